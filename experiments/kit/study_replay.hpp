#pragma once

#include "experiments/kit/experiment.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// Runs a study (a file that describes many runs of a netlist) from the examples, as a part of an experiment. The user
/// may have edited this file. If the file lacks something that the replay needs, the functions below throw UserError
/// with the file's name.
class StudyReplay {
public:
    /// Makes the runs of the study. `file` is a path below the folder of the examples. Throws RefusedInput, UserError
    /// and UnfinishedRun.
    StudyReplay(const ReplayContext&, const std::string& file);

    /// Returns the study's tables and notes. The fingerprint covers all runs of the study in their order.
    Replay replay() const;
    /// Returns the table with this name. The first argument is the result of replay().
    Comparison& table(Replay&, const std::string& name) const;
    /// Returns the first number in the name of a row or column: 12 in "tree of 12 slaves".
    double number_in(const std::string& name) const;
    /// Returns the measure of the run with these settings.
    double measured(const Overrides& set, const std::string& measure) const;
    std::uint64_t fingerprint(const Overrides& set) const { return outcome_of({set, study_.first_seed}).fingerprint; }
    [[noreturn]] void refuse(const std::string& why) const;

private:
    void require_tables() const;
    /// Loads the netlists of all runs and shows their warnings. Throws if the study uses a measure that no run can
    /// have.
    void look_at_netlists() const;
    StudyOutcome outcome_of(const StudyRun&) const;

    const ReplayContext& context_;
    std::string path_;
    Study study_;
};

} // namespace placedpar
