#include "app/command.hpp"
#include "app/options/netlist_options.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

ExitCode check(const NetlistOptions& options) {
    Network network = load_network(options);
    print_out(fmt::format("{}: {}, {}, {}, {}; hash {:016x}\n", network.source_path,
                          counted(count_processors(network), "processor"), counted(network.count_wires(), "connection"),
                          counted(network.processes.size(), "process", "processes"),
                          counted(network.channels.size(), "channel"), network.hash));
    return ExitCode::success;
}

Action declare_check(Options& command, const std::string&) {
    auto options = std::make_shared<NetlistOptions>();
    add_netlist(command, *options);
    return [options] { return check(*options); };
}

} // namespace

extern const Command check_command{
    .name = "check",
    .about = "Reads and checks a netlist",
    .place = 30,
    .declare = declare_check,
};

} // namespace placedpar
