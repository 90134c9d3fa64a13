#include "experiments/kit/study_replay.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "explore/study/comparisons.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/sweep.hpp"
#include "explore/workers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

/// Throws UserError where there is no such machine, and UnfinishedRun.
void require_whole(const StudyOutcome& outcome, const std::string& netlist) {
    if (!outcome.refused.empty())
        throw UserError(outcome.refused);
    for (Ending ending : {Ending::stuck, Ending::time_limit})
        if (outcome.ended == name_of(ending))
            throw UnfinishedRun(fmt::format("{} did not come to its end: placedpar run shows where it stands", netlist),
                                ending);
}

} // namespace

StudyReplay::StudyReplay(const ReplayContext& context, const std::string& file)
    : context_(context), study_(read_study((context.examples / file).string())) {
    study_.first_seed = context.seed;
    StudySweep sweep(study_, context.results);
    const std::uint64_t missing = sweep.missing().runs;
    auto show = [&](std::uint64_t ended) { context.progress(fmt::format("{} of {} runs", ended, missing)); };
    show(0);
    sweep.run(std::min<std::uint64_t>(count_cores(), missing), context.interruption, show);
    end_if_requested(context.interruption);
}

StudyOutcome StudyReplay::outcome_of(const StudyRun& run) const {
    StudyOutcome outcome = context_.results.find(run).value();
    require_whole(outcome, study_.netlist);
    return outcome;
}

Replay StudyReplay::replay() const {
    Fingerprint fingerprint;
    for (std::uint64_t i = 0; i < study_.count(); ++i)
        if (auto run = study_.at(i))
            fingerprint.mix(outcome_of(*run).fingerprint);
    return {.comparisons = comparisons_of(study_, context_.results),
            .constants = study_.notes,
            .fingerprint = fingerprint.value()};
}

double StudyReplay::measured(const Overrides& set, const std::string& measure) const {
    const StudyOutcome outcome = outcome_of({set, study_.first_seed});
    auto figure = StudyMeasure(measure).of(outcome.figures);
    if (!figure)
        throw UserError(there_is_no_measure(StudyMeasure(measure), outcome.figures));
    return figure->value;
}

} // namespace placedpar
