#include "experiments/kit/study_replay.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "explore/study/comparisons.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/summary_cells.hpp"
#include "explore/study/sweep.hpp"
#include "explore/workers.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace placedpar {

namespace {

/// Throws UserError if the netlist has errors, and UnfinishedRun if the run did not complete.
void require_whole(const StudyOutcome& outcome, const std::string& netlist) {
    if (!outcome.refused.empty())
        throw UserError(outcome.refused);
    for (RunOutcome ended : {RunOutcome::time_limit, RunOutcome::failed, RunOutcome::halted, RunOutcome::deadlock})
        if (outcome.ended == name_of(ended))
            throw UnfinishedRun(fmt::format("{} did not complete: placedpar run shows where it stopped", netlist),
                                ended);
}

} // namespace

StudyReplay::StudyReplay(const ReplayContext& context, const std::string& file)
    : context_(context), path_((context.examples / file).string()), study_(read_study(path_)) {
    require_tables();
    study_.first_seed = context.seed;
    look_at_netlists();
    StudySweep sweep(study_, context.results);
    const std::uint64_t missing = sweep.missing().runs;
    auto show = [&](std::uint64_t ended) { context.progress(fmt::format("{} of {} runs", ended, missing)); };
    show(0);
    sweep.run(std::min<std::uint64_t>(count_cores(), missing), context.interruption, show);
    end_if_requested(context.interruption);
}

void StudyReplay::refuse(const std::string& why) const { throw UserError(fmt::format("{}: {}", path_, why)); }

void StudyReplay::require_tables() const {
    if (study_.tables.empty())
        refuse("the study has no [[table]], but a replay needs one");
    if (study_.seeds != 1 || study_.first_seed != 1)
        refuse("the seed of a replay comes from --seed: remove seeds and first_seed from the study");
}

void StudyReplay::look_at_netlists() const {
    const ProblemRegistry problems = known_problems(context_.seed);
    const Catalogue kinds = known_kinds(problems);
    const ParsedNetlist netlist(study_.netlist, study_.read);
    std::set<std::string> told;
    auto warn = [&](const std::string& warnings) {
        if (told.insert(warnings).second)
            context_.warn(warnings);
    };
    PossibleMeasures possible;
    const StudyRuns runs(study_);
    for (std::uint64_t i = 0; i < runs.count(); ++i)
        if (auto run = runs.at(i))
            possible.add(load_network(netlist, run->set, kinds, warn), kinds, problems);
    for (const std::string& each : study_.figures)
        if (const StudyMeasure measure(each); !possible.has(measure))
            refuse(possible.why_unknown(measure));
}

Comparison& StudyReplay::table(Replay& replay, const std::string& name) const {
    std::vector<std::string> names;
    for (Comparison& each : replay.comparisons)
        if (each.name == name)
            return each;
        else
            names.push_back(each.name);
    refuse(fmt::format("the replay needs a table \"{}\", but the study has only \"{}\"", name,
                       fmt::join(names, "\", \"")));
}

double StudyReplay::number_in(const std::string& name) const {
    const std::size_t first = name.find_first_of("0123456789");
    const std::size_t behind = std::min(name.find_first_not_of("0123456789.", first), name.size());
    auto number =
        first == name.npos ? std::nullopt : parse_number<double>(std::string_view(name).substr(first, behind - first));
    if (!number)
        refuse(fmt::format("the replay needs a number in the name \"{}\", as in \"12 slaves\"", name));
    return *number;
}

StudyOutcome StudyReplay::outcome_of(const StudyRun& run) const {
    const std::optional<StudyOutcome> outcome = context_.results.find(run);
    if (!outcome)
        refuse(fmt::format("the replay needs a run with {}, which the study lacks", shown_settings(run.set)));
    require_whole(*outcome, study_.netlist);
    return *outcome;
}

Replay StudyReplay::replay() const {
    Fingerprint fingerprint;
    const StudyRuns runs(study_);
    for (std::uint64_t i = 0; i < runs.count(); ++i)
        if (auto run = runs.at(i))
            fingerprint.mix(outcome_of(*run).fingerprint);
    Replay replay{.comparisons = comparisons_of(study_, context_.results),
                  .constants = study_.notes,
                  .fingerprint = fingerprint.value()};
    for (const Comparison& table : replay.comparisons)
        for (const Cell& cell : table.cells)
            if (std::isnan(cell.simulated))
                refuse(fmt::format("the table \"{}\" has no figure in \"{}\", \"{}\"\n{}", table.name, cell.row,
                                   cell.column, table.notes));
    return replay;
}

double StudyReplay::measured(const Overrides& set, const std::string& measure) const {
    const StudyOutcome outcome = outcome_of({set, study_.first_seed});
    auto figure = StudyMeasure(measure).of(outcome.figures);
    if (!figure)
        refuse(there_is_no_measure(StudyMeasure(measure), outcome.figures));
    return figure->value;
}

} // namespace placedpar
