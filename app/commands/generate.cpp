#include "explore/generate/generate.hpp"
#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "explore/generate/topology.hpp"
#include "explore/problems.hpp"
#include "text/output_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>

namespace placedpar {

namespace {

struct GenerateOptions {
    generate::Wish wish;
    std::string out = "-";
};

ExitCode generate_netlist(const GenerateOptions& options) {
    std::string text = generate::generate(options.wish, known_kinds(known_problems(0))).text;
    write_whole(options.out, text);
    return ExitCode::success;
}

void add_topology(CLI::App& command, generate::Wish& wish) {
    std::string names = fmt::format("{}", fmt::join(generate::names_of_topologies(), ", "));
    command.add_option("TOPOLOGY", wish.topology, names)->required();
}

void add_size(CLI::App& command, generate::Wish& wish) {
    command
        .add_option("--size", wish.size, "of a mesh or torus rows and columns, of figure-e2 chains and their length")
        ->type_name("PROCESSORS|NxN")
        ->required();
}

void add_if_said(CLI::App& command, const char* option, std::optional<std::size_t>& value, const char* about) {
    command.add_option(option, value, about)->type_name("N")->check(not_a_whole_number);
}

void add_shape(CLI::App& command, generate::Wish& wish) {
    add_if_said(command, "--branches", wish.branches, "of a tree: how many are below each; 2 unless said");
    add_if_said(command, "--chord", wish.chord, "of a chordal ring: how far chords lead; about its root unless said");
    add_if_said(command, "--degree", wish.degree, "of a chordal ring: links of each to others, 3 or 4; 3 unless said");
}

void add_job(CLI::App& command, generate::Wish& wish) {
    const char* about = "what runs on it: KIND is a kind of process, one on each processor";
    add_file(command, "--job", wish.job, about, "farm|islands|KIND")->capture_default_str();
}

void add_host(CLI::App& command, generate::Wish& wish) {
    command
        .add_option("--host", wish.host, "where the host's process runs: on a node where no link is left for a wire")
        ->check(CLI::IsMember({"workstation", "node"}).description(""))
        ->type_name("workstation|node")
        ->capture_default_str();
}

void add_ports(CLI::App& command, generate::Wish& wish) {
    const char* about = "of a KIND: its array of outputs to its neighbours";
    add_file(command, "--output", wish.output, about, "PORT")->capture_default_str();
    add_file(command, "--input", wish.input, "of a KIND: its array of inputs from them", "PORT")->capture_default_str();
}

void add_wish(CLI::App& command, generate::Wish& wish) {
    add_topology(command, wish);
    add_size(command, wish);
    add_shape(command, wish);
    add_job(command, wish);
    add_host(command, wish);
    add_ports(command, wish);
}

Action declare_generate(CLI::App& command, const std::string&) {
    auto options = std::make_shared<GenerateOptions>();
    add_wish(command, options->wish);
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
