#include "explore/study/sweep.hpp"
#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/many_runs.hpp"
#include "app/options/netlist_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "explore/study/comparisons.hpp"
#include "explore/study/rank_helper.hpp"
#include "explore/study/rank_zero.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "explore/workers.hpp"
#include "ranks/ranks.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace placedpar {

namespace {

struct SweepOptions {
    std::string study; ///< a netlist, or a study's file
    std::vector<std::string> settings, measures;
    ReadOptionsTyped read;
    std::optional<std::uint64_t> seed, seeds;
    std::optional<Time> until;
    std::string results; ///< "": the file is named after the study
    std::size_t jobs = 0;
    bool yes = false, any_version = false;
};

/// Adds an axis, that is, a setting with the values that the sweep gives it. Replaces an axis of the same name.
void set_axis(StudyProduct& product, const StudyAxis& axis) {
    auto found = std::ranges::find(product.axes, axis.name, &StudyAxis::name);
    if (found == product.axes.end())
        product.axes.push_back(axis);
    else
        *found = axis;
}

/// Returns whether the table's cells differ in this setting.
bool varies(const StudyTable& table, const std::string& name) {
    auto sets = [&](const StudyVariant& runs) { return runs.set.contains(name); };
    return std::ranges::any_of(table.columns, sets) || std::ranges::any_of(table.rows, [&](const StudyRow& row) {
               return sets(row.runs) || row.relative_to.contains(name);
           });
}

/// Applies the axis, a setting with its values, to the table. A table assigns its runs to cells, so the setting can
/// have only one value.
void set_in_table(StudyTable& table, const StudyAxis& axis) {
    if (axis.count() > 1)
        throw UserError(fmt::format("{} was given several values, but the study's table \"{}\" takes one value",
                                    axis.name, table.name));
    if (varies(table, axis.name))
        throw UserError(fmt::format("the study's table \"{}\" sets {} in its columns, rows or relative_to, so "
                                    "the command line cannot set it",
                                    table.name, axis.name));
    table.shared[axis.name] = axis.at(0);
}

void add_settings(Study& study, const SweepOptions& options) {
    std::vector<std::string> given;
    for (const std::string& text : options.settings) {
        StudyAxis axis = read_axis(text);
        if (std::ranges::find(given, axis.name) != given.end())
            throw UserError(fmt::format("{}: {} is set twice", text, axis.name));
        given.push_back(axis.name);
        for (StudyProduct& product : study.products)
            set_axis(product, axis);
        for (StudyTable& table : study.tables)
            set_in_table(table, axis);
    }
}

Study study_of(const SweepOptions& options) {
    Study study;
    if (lower_case(options.study).ends_with(".toml")) {
        study = read_study(options.study);
    } else {
        study.netlist = options.study;
        study.products.emplace_back();
    }
    add_settings(study, options);
    ReadOptions read = read_options_of(options.read);
    std::ranges::copy(read.include_folders, std::back_inserter(study.read.include_folders));
    std::ranges::copy(read.faults, std::back_inserter(study.read.faults));
    study.read.programs.merge(read.programs);
    study.read.make_netlist = read.make_netlist;
    study.first_seed = options.seed.value_or(study.first_seed);
    study.seeds = options.seeds.value_or(study.seeds);
    study.until = options.until.value_or(study.until);
    if (!options.measures.empty())
        study.measures = options.measures;
    if (study.measures.empty())
        study.measures = study.search ? study.search->minimise : std::vector<std::string>{"time"};
    return study;
}

void require_reference_run(const Study& study) {
    if (!study.relative_to.empty() && !study.has_some(study.relative_to))
        throw UserError(there_is_no_reference(study.relative_to, study.names()));
}

std::filesystem::path results_of(const SweepOptions& options) {
    if (options.results.empty() && is_standard_stream(options.study))
        throw UserError("a netlist from standard input gives the results no name: add --results FILE.sqlite");
    return options.results.empty() ? std::filesystem::path(options.study).stem().string() + ".sqlite" : options.results;
}

/// Shows one line with the progress and the remaining time.
class SweepProgress {
public:
    /// Shows the progress of the runs that the results lack. `made`: how many of these runs have been made already.
    SweepProgress(const StudySweep::Missing& missing, std::uint64_t made) : missing_(missing), made_(made) {}

    void show(std::uint64_t ended) {
        progress_.show(fmt::format("{} of {}{} runs, {}", print_count(made_ + ended), missing_.exact ? "" : "at most ",
                                   print_count(missing_.runs), left(ended)));
    }

private:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

    std::string left(std::uint64_t ended) const {
        if (ended == 0)
            return seconds() < patience_seconds ? "no run has finished yet"
                                                : "no run has finished yet; --until TIME stops endless runs";
        auto runs = static_cast<double>(missing_.runs - std::min(made_ + ended, missing_.runs));
        return print_duration(seconds() * runs / static_cast<double>(ended)) + " left";
    }

    using Clock = std::chrono::steady_clock; // wall-clock time; it does not affect any run
    static constexpr double patience_seconds = 20;

    StudySweep::Missing missing_;
    std::uint64_t made_;
    Clock::time_point begun_ = Clock::now();
    ProgressLine progress_;
};

void say_interrupted(const StudyResults& results) {
    print_error(fmt::format("interrupted; {} keeps the finished runs: type the same command again to continue\n",
                            results.path().string()));
}

/// Returns the number of threads that make runs, at most one for each run.
std::size_t workers_for(const StudySweep::Missing& missing, const SweepOptions& options) {
    return std::min<std::uint64_t>(options.jobs, std::max<std::uint64_t>(missing.runs, 1));
}

/// Makes the missing runs. Returns false if the sweep was interrupted or the user did not confirm it.
bool make_missing_runs(const Study& study, const SweepOptions& options, StudyResults& results,
                       Interruption& interruption, RankZero* others) {
    StudySweep sweep(study, results);
    const StudySweep::Missing asked = sweep.missing();
    StudySweep::Missing missing = asked;
    std::size_t at_once = options.jobs * (others ? others->ranks() : 1);
    if (missing.runs > most_unasked && !options.yes)
        if (auto seconds = sweep.seconds_a_run(interruption);
            seconds && !are_meant({missing.runs, missing.exact, at_once, *seconds}, interruption))
            return false;
    sweep.try_measures(interruption);
    missing = sweep.missing();
    SweepProgress progress(asked, asked.runs - std::min(missing.runs, asked.runs)); // with runs of try_measures()
    std::function<bool(bool)> serve;
    if (others) {
        others->begin(sweep, results.source());
        serve = [&](bool stopped) { return others->serve(stopped); };
    }
    sweep.run(
        workers_for(missing, options), interruption, [&](std::uint64_t ended) { progress.show(ended); }, serve);
    return !interruption.requested();
}

/// Prints the study's tables and returns whether they are within their tolerances.
ExitCode print_tables(const Study& study, StudyResults& results) {
    if (study.tables.empty())
        return ExitCode::success;
    const std::vector<Comparison> tables = comparisons_of(study, results);
    std::string out;
    for (const Comparison& table : tables)
        out += "\n" + print_comparison(table);
    out += study.notes.empty() ? "" : "\n" + study.notes;
    print_out(
        out + "\n" +
        (is_any_judged(tables) ? print_verdict(tables, "table") : "nothing is judged: no cell has a tolerance\n"));
    return are_within_tolerance(tables) ? ExitCode::success : ExitCode::missed_tolerance;
}

/// Makes runs for rank 0 in another rank, one of the processes that mpirun started.
ExitCode help(Ranks& ranks, const SweepOptions& options) {
    InterruptedBySignals interruption;
    RankHelper(ranks, options.jobs).help([&] { return study_of(options); }, interruption);
    return ExitCode::success;
}

/// Makes the sweep, with the help of other ranks if this is rank 0 of several.
ExitCode sweep(const SweepOptions& options, RankZero* others) {
    const std::filesystem::path path = results_of(options);
    Study study = study_of(options);
    for (const std::string& measure : study.measures)
        StudyMeasure{measure};
    require_reference_run(study);
    Network network = readable_network(study);
    require_possible(study.measures, study, network);
    if (!study.tables.empty())
        require_possible(study.figures, study, network);
    StudyResults results(path, source_of(study, network), options.any_version);
    InterruptedBySignals interruption;
    results.set_measures(study.measures);
    bool whole = make_missing_runs(study, options, results, interruption, others);
    if (interruption.requested() || (others && others->in_hand() > 0)) {
        say_interrupted(results);
        return ExitCode::interrupted;
    }
    if (!whole)
        return ExitCode::success;
    print_out(print_summary(summary_of(results, {}, &study, study.relative_to)));
    const ExitCode code = print_tables(study, results);
    print_out(fmt::format("\nresults: {}\n", results.path().string()));
    return code;
}

ExitCode sweep(const SweepOptions& typed) {
    std::unique_ptr<Ranks> ranks = ranks_of_mpirun();
    SweepOptions options = typed;
    if (options.jobs == 0)
        options.jobs = ranks ? 1 : count_cores();
    if (!ranks)
        return sweep(options, nullptr);
    if (ranks->own() > 0)
        return help(*ranks, options);
    RankZero others(*ranks);
    return sweep(options, &others);
}

void add_size(Options& command, SweepOptions& options) {
    add_count(command, "--seed", options.seed, "the first seed; default: 1");
    add_count(command, "--seeds", options.seeds, "number of consecutive seeds for each combination")
        .check(not_at_least_one);
    command.add("--until", options.until, "stops each run at this simulated time");
    add_jobs(command, options.jobs,
             "number of parallel runs; default: number of cores, or one for each rank of "
             "mpirun");
}

Action declare_sweep(Options& command, const std::string&) {
    auto options = std::make_shared<SweepOptions>();
    command
        .add("STUDY", options->study,
             "a netlist (.cfs), or a study that names one (.toml); - reads a netlist from standard input")
        .required()
        .check(not_a_name);
    command
        .add("SETTING", options->settings,
             "NAME=VALUES: values to try, in all combinations, such as slaves=0..7 linkspeed=5M,10M")
        .type("");
    command.add_list("--measure", options->measures, "MEASURE",
                     "a measure to report, such as time, master.T_exe or max(slave.T_c); may be repeated");
    add_size(command, *options);
    add_read_options(command, options->read);
    add_file(command, "--results", options->results,
             "file of the results, which is read and extended; default: the study's name with .sqlite, in the current "
             "folder");
    command.add_flag("--yes", options->yes, "starts any number of runs without asking");
    command.add_flag("--any-version", options->any_version,
                     "adds runs even if another version of PlacedPar made the results in the file");
    return [options] { return sweep(*options); };
}

} // namespace

extern const Command sweep_command{
    .name = "sweep",
    .about = "Runs a netlist with many settings and seeds on all cores, and keeps the results",
    .place = 22,
    .declare = declare_sweep,
};

} // namespace placedpar
