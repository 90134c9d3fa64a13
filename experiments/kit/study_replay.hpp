#pragma once

#include "experiments/kit/experiment.hpp"
#include "explore/study/study.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// A study with tables beside a netlist of the examples, run for a replay.
class StudyReplay {
public:
    /// Makes its runs. `file`: below the folder of the examples. Throws RefusedInput, UserError and UnfinishedRun.
    StudyReplay(const ReplayContext&, const std::string& file);

    /// Its tables and notes, with the fingerprint of all its runs in their order.
    Replay replay() const;
    /// What the run with these settings measured. Throws UserError where it did not. REQUIRES: the study has it.
    double measured(const Overrides& set, const std::string& measure) const;
    /// REQUIRES: as before.
    std::uint64_t fingerprint(const Overrides& set) const { return outcome_of({set, study_.first_seed}).fingerprint; }

private:
    StudyOutcome outcome_of(const StudyRun&) const;

    const ReplayContext& context_;
    Study study_;
};

} // namespace placedpar
