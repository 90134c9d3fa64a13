#include "app/command.hpp"
#include "app/options/netlist_options.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "text/output_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

ExitCode check(const NetlistOptions& options) {
    Network network = load_network(options);
    print_out(fmt::format("{}: {} processors, {} connections, {} processes, {} channels; hash {:016x}\n",
                          network.source_path, count_processors(network), network.connections.size(),
                          network.processes.size(), network.channels.size(), network.hash));
    return ExitCode::success;
}

Action declare_check(CLI::App& command, const std::string&) {
    auto options = std::make_shared<NetlistOptions>();
    add_netlist(command, *options);
    return [options] { return check(*options); };
}

} // namespace

extern const Command check_command{
    .name = "check",
    .about = "Reads and checks a netlist",
    .place = 2,
    .declare = declare_check,
};

} // namespace placedpar
