#pragma once

#include "experiments/kit/experiment.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// A study with tables beside a netlist of the examples, run for a replay. Its file may have been edited: functions
/// throw UserError with the file's name where it does not have what the replay needs.
class StudyReplay {
public:
    /// Makes its runs. `file`: below the folder of the examples. Throws RefusedInput, UserError and UnfinishedRun.
    StudyReplay(const ReplayContext&, const std::string& file);

    /// Its tables and notes, with the fingerprint of all its runs in their order.
    Replay replay() const;
    /// The table of that name among those of replay().
    Comparison& table(Replay&, const std::string& name) const;
    /// The first number in the name of a row or column: 12 in "tree of 12 slaves".
    double number_in(const std::string& name) const;
    /// What the run with these settings measured.
    double measured(const Overrides& set, const std::string& measure) const;
    std::uint64_t fingerprint(const Overrides& set) const { return outcome_of({set, study_.first_seed}).fingerprint; }
    [[noreturn]] void refuse(const std::string& why) const;

private:
    void require_tables() const;
    /// Loads its netlists, so that their warnings are told, and figures that no run can have are refused.
    void look_at_netlists() const;
    StudyOutcome outcome_of(const StudyRun&) const;

    const ReplayContext& context_;
    std::string path_;
    Study study_;
};

} // namespace placedpar
