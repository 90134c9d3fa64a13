#include "app/command.hpp"
#include "app/options/netlist_options.hpp"
#include "app/options/occam_options.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

ExitCode check_program(const NetlistOptions& options, const OccamOptions& occam) {
    const std::string main = check_occam(options.file, options.read.include, occam, print_warnings);
    print_out(fmt::format("{}: no errors; {}\n", options.file,
                          main.empty() ? "it has no procedure" : fmt::format("PROC {} would be run", main)));
    return ExitCode::success;
}

ExitCode check(const NetlistOptions& options, const OccamOptions& occam) {
    if (is_occam(options.file))
        return check_program(options, occam);
    Network network = load_network(options);
    print_out(fmt::format("{}: {}, {}, {}, {}; hash {:016x}\n", network.source_path,
                          counted(count_processors(network), "processor"), counted(network.count_wires(), "connection"),
                          counted(network.processes.size(), "process", "processes"),
                          counted(network.channels.size(), "channel"), network.hash));
    return ExitCode::success;
}

Action declare_check(Options& command, const std::string&) {
    auto options = std::make_shared<NetlistOptions>();
    auto occam = std::make_shared<OccamOptions>();
    add_netlist(command, *options);
    add_occam(command, *occam);
    return [options, occam] { return check(*options, *occam); };
}

} // namespace

extern const Command check_command{
    .name = "check",
    .about = "Reads and checks a netlist, or a program in occam",
    .place = 30,
    .declare = declare_check,
};

} // namespace placedpar
