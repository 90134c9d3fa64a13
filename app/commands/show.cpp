#include "app/command.hpp"
#include "app/options/netlist_options.hpp"
#include "netlist/print/print.hpp"
#include "text/output_file.hpp"
#include "workbench/picture/svg.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace placedpar {

namespace {

struct ShowOptions {
    NetlistOptions netlist;
    std::string format = "cfs";
};

ExitCode show(const ShowOptions& options) {
    Network network = load_network(options.netlist);
    print_out(options.format == "cfs"   ? print_cfs(network)
              : options.format == "svg" ? print_svg(network)
              : options.format == "dot" ? print_dot(network)
                                        : print_json(network));
    return ExitCode::success;
}

Action declare_show(CLI::App& command, const std::string&) {
    auto options = std::make_shared<ShowOptions>();
    add_netlist(command, options->netlist);
    command.add_option("--format", options->format, "the netlist language, a drawing, a drawing for Graphviz, or JSON")
        ->check(CLI::IsMember({"cfs", "svg", "dot", "json"}).description(""))
        ->type_name("cfs|svg|dot|json")
        ->capture_default_str();
    return [options] { return show(*options); };
}

} // namespace

extern const Command show_command{
    .name = "show",
    .about = "Prints the elaborated network",
    .place = 3,
    .declare = declare_show,
};

} // namespace placedpar
