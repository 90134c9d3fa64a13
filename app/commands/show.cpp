#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/native_options.hpp"
#include "app/options/netlist_options.hpp"
#include "explore/occam_program.hpp"
#include "explore/problems.hpp"
#include "netlist/print/print.hpp"
#include "netlist/print/promela.hpp"
#include "picture/svg.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace placedpar {

namespace {

struct ShowOptions {
    NetlistOptions netlist;
    std::string format = "cfs", out;
    bool software = false;
};

std::string text_of(const Network& network, const std::string& format, bool software) {
    return software              ? print_software_svg(network)
           : format == "cfs"     ? print_cfs(network)
           : format == "svg"     ? print_svg(network)
           : format == "dot"     ? print_dot(network)
           : format == "promela" ? print_promela(network, known_kinds(known_problems(0)))
                                 : print_json(network);
}

void require_apart_from_inputs(const std::filesystem::path& output, const Network& network,
                               const std::string& netlist) {
    require_apart({&output, 1}, netlist);
    for (const std::string& input : paths_of_inputs(network))
        require_apart({&output, 1}, input);
}

void require_drawing(const ShowOptions& options) {
    if (options.software && options.format != "svg")
        throw UserError("--software needs the output format svg: write --format svg --software");
}

ExitCode show(const ShowOptions& options) {
    require_drawing(options);
    if (options.format == "cfs")
        require_netlist(options.netlist.file);
    Network network = load_network(options.netlist);
    std::string text = text_of(network, options.format, options.software);
    if (options.out.empty()) {
        print_out(text);
    } else {
        require_apart_from_inputs(options.out, network, options.netlist.file);
        write_whole(options.out, text);
    }
    return ExitCode::success;
}

Action declare_show(Options& command, const std::string&) {
    auto options = std::make_shared<ShowOptions>();
    add_netlist(command, options->netlist);
    add_predict(command, options->netlist);
    add_threads(command, options->netlist.threads);
    command
        .add("--format", options->format, "output format: netlist language, drawing, Graphviz, JSON, or model for Spin")
        .one_of({"cfs", "svg", "dot", "json", "promela"})
        .show_default();
    command.add_flag("--software", options->software,
                     "with --format svg: draws processes and channels instead of processors and wires");
    add_file(command, "-o,--out", options->out, "writes to this file; default: standard output");
    return [options] { return show(*options); };
}

} // namespace

extern const Command show_command{
    .name = "show",
    .about = "Prints a netlist's network with every loop and condition written out",
    .place = 40,
    .declare = declare_show,
};

} // namespace placedpar
