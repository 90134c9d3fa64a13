#include "explore/generate/generate.hpp"
#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "explore/generate/topology.hpp"
#include "explore/problems.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

struct GenerateOptions {
    generate::TopologyRequest request;
    std::string out = "-";
};

ExitCode generate_netlist(const GenerateOptions& options) {
    std::string text = generate::generate(options.request, known_kinds(known_problems(0))).text;
    write_whole(options.out, text);
    return ExitCode::success;
}

void add_wish(Options& command, generate::TopologyRequest& request) {
    command.add("TOPOLOGY", request.topology, fmt::format("{}", fmt::join(generate::names_of_topologies(), ", ")))
        .required();
    command.add("--size", request.size, "of a mesh or torus rows and columns, of figure-e2 chains and their length")
        .type("PROCESSORS|NxN")
        .required();
    add_count(command, "--branches", request.branches, "of a tree: how many are below each; 2 unless said");
    add_count(command, "--chord", request.chord, "of a chordal ring: how far chords lead; about its root unless said");
    add_count(command, "--degree", request.degree, "of a chordal ring: links of each to others, 3 or 4; 3 unless said");
    add_file(command, "--job", request.job, "what runs on it: KIND is a kind of process, one on each processor",
             "farm|islands|KIND")
        .show_default();
    command.add("--host", request.host, "where the host's process runs: on a node where no link is left for a wire")
        .one_of({"workstation", "node"})
        .show_default();
    add_file(command, "--output", request.output, "of a KIND: its array of outputs to its neighbours", "PORT")
        .show_default();
    add_file(command, "--input", request.input, "of a KIND: its array of inputs from them", "PORT").show_default();
}

Action declare_generate(Options& command, const std::string&) {
    auto options = std::make_shared<GenerateOptions>();
    add_wish(command, options->request);
    add_file(command, "-o,--out", options->out, "writes it there, not to standard output");
    return [options] { return generate_netlist(*options); };
}

} // namespace

extern const Command generate_command{
    .name = "generate",
    .about = "Writes the netlist of a machine: a topology, its size, and a job to run on it",
    .place = 21,
    .declare = declare_generate,
    .values = generate::names_of_topologies,
};

} // namespace placedpar
