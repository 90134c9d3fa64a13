#include "experiments/kit/experiment.hpp"
#include "explore/problems.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/hardware/constants.hpp"

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

using hardware::Constant;
using hardware::Provenance;

constexpr std::string_view machine = "machine", evidence = "evidence";

/// Collects in one table every published figure that the other experiments of the machine are compared with.
class PublishedFigures {
public:
    void add(const Replay& replay) {
        fingerprint_.mix(replay.fingerprint);
        std::ranges::copy(replay.constant_table, std::back_inserter(constants_));
        for (const Comparison& comparison : replay.comparisons)
            for (Cell cell : comparison.cells) {
                cell.column = "figure";
                all_.add(cell);
            }
    }
    const Comparison& all() const { return all_; }
    /// Returns the constants that only a single experiment uses.
    const std::vector<Constant>& constants() const { return constants_; }
    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    Comparison all_{
        .name = "published figures",
        .notes = "outcome: the figure follows from rules and constants that come from other figures, so it "
                 "can be wrong\nconstant: the figure is one constant of the model, so it tests the program, not the "
                 "model\ncalibrated, fitted: one constant, or several, were set such that the model gives the figure\n",
        .against = "publ.",
        .judged = true,
        .names_origins = true};
    std::vector<Constant> constants_;
    Fingerprint fingerprint_;
};

Network network_of(const ReplayContext& context, const char* netlist) {
    return load_network(context.examples / netlist, {}, known_problems(context.seed), context.warn);
}

/// Returns the costs of the thesis's program that the netlist of Table E.1 states.
std::vector<Constant> of_the_thesis(const Network& cluster) {
    constexpr std::string_view group = "the thesis's program";
    const ProcessInstance& master = *std::ranges::find(cluster.processes, "master", &ProcessInstance::name);
    auto stated = [&](const char* parameter) {
        return static_cast<double>(std::get<std::int64_t>(master.parameters.at(parameter)));
    };
    using enum Provenance;
    return {
        {group, "an individual's error at one sample", stated("cycles_per_error"), "cycles", workload,
         "Table E.1, P_time2 without slaves"},
        {group, "genetic operators for an individual", stated("cycles_per_individual"), "cycles", workload,
         "Table E.1, S_time2 without slaves"},
        {group, "preparing a word of measurements", stated("cycles_per_measurement_word"), "cycles", calibrated,
         "Table E.1, C_time2 with 3 slaves"},
        {group, "an individual's string", stated("string_bytes"), "bytes", workload, "appendix E: 240 of 120"},
        {group, "an individual's fitness", stated("fitness_bytes"), "bytes", workload, "appendix E: 240 of 120"},
        {group, "measurements of a sample", stated("measurement_bytes"), "bytes", workload, "appendix E"},
    };
}

Constant of_the_toolset(const Network& ping_pong) {
    return {"INMOS C toolset",
            "a call of ChanIn or ChanOut",
            static_cast<double>(ping_pong.nodes.front().integer("channelcall")),
            "cycles",
            Provenance::calibrated,
            "half a round trip, to start (Poznan, 2008)"};
}

std::vector<Constant> every_constant(const ReplayContext& context, const std::vector<Constant>& of_experiments) {
    std::vector<Constant> all = hardware::constants();
    all.push_back(of_the_toolset(network_of(context, "machine/poznan/ping-pong.cfs")));
    for (const Constant& each : of_the_thesis(network_of(context, "thesis/table-e1/cluster.cfs")))
        all.push_back(each);
    std::ranges::copy(of_experiments, std::back_inserter(all));
    return all;
}

Replay replay_evidence(const ReplayContext& context) {
    PublishedFigures figures;
    for (const Experiment& each : experiments())
        if (each.chapter == machine && each.name != evidence)
            figures.add(each.run(context));
    return {.comparisons = {figures.all()},
            .constant_table = every_constant(context, figures.constants()),
            .fingerprint = figures.fingerprint()};
}

} // namespace

extern const Experiment evidence_experiment{
    .name = evidence,
    .about = "every constant of time with its source, and every published figure beside the simulated figure",
    .chapter = machine,
    .number = 100, // after all other experiments of the machine
    .run = replay_evidence,
};

} // namespace placedpar
