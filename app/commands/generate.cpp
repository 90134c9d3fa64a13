#include "explore/generate/generate.hpp"
#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "explore/generate/topology.hpp"
#include "explore/problems.hpp"
#include "text/output_file.hpp"
#include "text/program_name.hpp"

#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

struct GenerateOptions {
    generate::TopologyRequest request;
    std::string out = "-";
};

ExitCode generate_netlist(const GenerateOptions& options) {
    const ProblemRegistry problems = known_problems(0);
    const std::string& name = options.request.problem;
    std::string text =
        generate::generate(options.request, known_kinds(problems), name.empty() ? nullptr : &problems.find(name)).text;
    write_whole(options.out, text);
    return ExitCode::success;
}

void add_wish(Options& command, generate::TopologyRequest& request) {
    command
        .add("TOPOLOGY", request.topology,
             fmt::format("{}; or a file with a graph (.graphml, .dot, .gv)",
                         fmt::join(generate::names_of_topologies(), ", ")))
        .required();
    command
        .add("--size", request.size,
             "number of processors; mesh, torus: rows x columns; mesh also planes x rows x columns; figure-e2: chains "
             "x processors in a chain")
        .type("PROCESSORS|NxN");
    command.add_flag(
        "--split", request.split,
        "builds each node of a graph with five or six edges from two processors, instead of refusing the graph");
    add_count(command, "--branches", request.branches, "tree: number of children of a processor; default: 2");
    add_count(command, "--chord", request.chord,
              "chordal ring: length of a chord, counted in processors along the ring; default: about the square root "
              "of the size");
    add_count(command, "--degree", request.degree, "chordal ring: links of a processor, 3 or 4; default: 3");
    add_file(command, "--job", request.job,
             "software: a farm, islands, the graph of tasks in a file, or one process of the kind KIND on each "
             "processor",
             "farm|islands|FILE.csv|KIND")
        .show_default();
    command
        .add("--problem", request.problem,
             fmt::format("the problem that the software searches; \"{} kinds problems\" lists all; default: boom",
                         program_name()))
        .type("PROBLEM")
        .check(not_a_name);
    command
        .add("--host", request.host,
             "where the host's process runs; choose node if no processor has a link "
             "left for the workstation")
        .one_of({"workstation", "node"})
        .show_default();
    add_file(command, "--output", request.output,
             "with --job KIND: name of the kind's array of outputs to the neighbours", "PORT")
        .show_default();
    add_file(command, "--input", request.input,
             "with --job KIND: name of the kind's array of inputs from the neighbours", "PORT")
        .show_default();
}

Action declare_generate(Options& command, const std::string&) {
    auto options = std::make_shared<GenerateOptions>();
    add_wish(command, options->request);
    add_file(command, "-o,--out", options->out, "writes the netlist to this file; default: standard output");
    return [options] { return generate_netlist(*options); };
}

} // namespace

extern const Command generate_command{
    .name = "generate",
    .about = "Writes the netlist of a machine with a given topology, size and software",
    .place = 21,
    .declare = declare_generate,
    .values = generate::names_of_topologies,
};

} // namespace placedpar
