#include "experiments/kit/experiment_runs.hpp"

#include "explore/problems.hpp"

#include <fmt/format.h>

namespace placedpar {

void require_end(const RunReport& report, const std::filesystem::path& netlist) {
    if (RunOutcome outcome = report.outcome(); outcome != RunOutcome::completed)
        throw UnfinishedRun(fmt::format("{} did not complete: placedpar run shows where it stopped", netlist.string()),
                            outcome);
}

void end_if_requested(const Interruption& interruption) {
    if (interruption.requested())
        throw UnfinishedRun("interrupted: the experiment is incomplete, so no table or plot was made",
                            RunOutcome::interrupted);
}

RunReport run_to_the_end(const Network& network, const ProblemRegistry& problems, const ReplayContext& context) {
    RunReport report = run_netlist(network, problems, {.seed = context.seed, .interruption = &context.interruption});
    end_if_requested(context.interruption);
    require_end(report, network.source_path);
    return report;
}

RunReport run_to_the_end(const std::filesystem::path& netlist, const Overrides& overrides,
                         const ReplayContext& context) {
    ProblemRegistry problems = known_problems(context.seed);
    Network network = load_network(netlist, overrides, problems, context.warn);
    return run_to_the_end(network, problems, context);
}

} // namespace placedpar
