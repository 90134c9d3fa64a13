#pragma once

#include "experiments/kit/experiment.hpp"
#include "explore/netlist_run.hpp"

#include <stdexcept>
#include <string>

namespace placedpar {

/// Thrown if a run of an experiment does not complete, because an incomplete run has no results to compare.
class UnfinishedRun : public std::runtime_error {
public:
    UnfinishedRun(const std::string& what, RunOutcome how) : std::runtime_error(what), outcome(how) {}
    RunOutcome outcome;
};

/// Throws UnfinishedRun if an interruption was requested.
void end_if_requested(const Interruption&);
/// Throws UnfinishedRun unless the run completed.
void require_end(const RunReport&, const std::filesystem::path& netlist);
/// Runs the network to its end, with the seed of the replay. Throws UnfinishedRun.
RunReport run_to_the_end(const Network&, const ProblemRegistry&, const ReplayContext&);
/// Runs a netlist of the examples to its end. Throws RefusedInput and UnfinishedRun.
RunReport run_to_the_end(const std::filesystem::path& netlist, const Overrides&, const ReplayContext&);

} // namespace placedpar
