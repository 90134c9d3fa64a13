#include "experiments/kit/experiment_runs.hpp"

#include "explore/problems.hpp"
#include "picture/svg.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace placedpar {

namespace {

constexpr const char* netlist_of_figure_e2 = "thesis/figure-e2/figure-e2.cfs";
constexpr const char* one_island = "master[0]";

double count_processes(const Network& network, std::string_view kind) {
    return static_cast<double>(std::ranges::count(network.processes, kind, &ProcessInstance::kind));
}

/// Returns the number of wires between a processor with a process of the kind `kind` and a processor with a process of
/// the kind `other`.
double count_wires(const Network& network, std::string_view kind, std::string_view other) {
    const auto has = [&](std::size_t node, std::string_view wanted) {
        return std::ranges::any_of(network.processes, [&](const ProcessInstance& process) {
            return process.node == node && process.kind == wanted;
        });
    };
    return static_cast<double>(std::ranges::count_if(network.connections, [&](const LinkConnection& wire) {
        return (has(wire.a.node, kind) && has(wire.b.node, other)) ||
               (has(wire.a.node, other) && has(wire.b.node, kind));
    }));
}

double population_of_an_island(const Network& network) {
    const auto& island = *std::ranges::find(network.processes, one_island, &ProcessInstance::name);
    return static_cast<double>(std::get<std::int64_t>(island.parameters.at("population")));
}

/// Compares the machine of the netlist with the machine that appendix E describes.
Comparison structure_of(const Network& network) {
    Comparison table{.name = "Figure E.2, the machine"};
    const double islands = count_processes(network, "ga.island"), slaves = count_processes(network, "ga.slave");
    const auto add = [&](const char* row, double thesis, double found) {
        table.add(judged_cell(row, "number", "", thesis, found, 0, 0));
    };
    add("transputers", 16, static_cast<double>(std::ranges::count(network.nodes, "T800", &Node::type)));
    add("islands", 4, islands);
    add("slaves of an island", 3, slaves / islands);
    add("links from a master to its slaves", 1, count_wires(network, "ga.island", "ga.slave") / islands);
    add("links that join the islands in a ring", 4, count_wires(network, "ga.island", "ga.island"));
    add("individuals of an island", 30, population_of_an_island(network));
    return table;
}

/// Returns the rate and the speedup of the run beside the figures of Table E.2. The thesis computed its rate as 12
/// times 9.8.
Comparison results_of(const RunReport& report) {
    Comparison table{.name = "Figure E.2, the run", .judged = true};
    table.add({.row = "generations of 120 individuals",
               .column = "simulated",
               .unit = "1/s",
               .reference = 117.6,
               .simulated = report.measured(one_island, "generations_per_second"),
               .tolerance_percent = 5,
               .decimals = 1});
    table.add({.row = "C_BOi",
               .column = "simulated",
               .unit = "in^3/psi",
               .reference = .0086,
               .simulated = report.measured(one_island, "C_BOi"),
               .tolerance_percent = 10,
               .decimals = 5,
               .judge = Judge::own});
    return table;
}

Replay replay_figure_e2(const ReplayContext& context) {
    const std::filesystem::path netlist = context.examples / netlist_of_figure_e2;
    const Network network = load_network(netlist, {}, known_problems(context.seed), context.warn);
    const RunReport report = run_to_the_end(netlist, {}, context);
    return {.comparisons = {structure_of(network), results_of(report)},
            .fingerprint = report.result.fingerprint,
            .drawings = {{"figure-e2", print_svg(network)}, {"figure-4-2", print_software_svg(network)}}};
}

} // namespace

extern const Experiment figure_e2_experiment{
    .name = "figure-e2",
    .about = "the machine of Figure E.2 with sixteen transputers, counted and run once",
    .chapter = "E",
    .number = 0,
    .run = replay_figure_e2,
};

} // namespace placedpar
