#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/many_runs.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "experiments/kit/examples_folder.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "experiments/kit/replay_report.hpp"
#include "explore/study/results.hpp"
#include "picture/gnuplot.hpp"
#include "report/manifest.hpp"
#include "text/meaning.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

namespace {

/// The greatest number of seeds. A number typed with too many digits must not fill the memory.
constexpr std::uint64_t most_seeds = 1'000'000;

/// The options of the command. If the name of a file is "", the file is not written.
struct ReplayOptions {
    std::string experiment, json, plots, resume;
    std::uint64_t seed = 1;
    std::size_t seeds = 0; ///< 0: the experiment's default number of seeds
    std::string against = "expected";
    bool yes = false;
};

std::string list_experiments() {
    std::string out;
    for (const Experiment& experiment : experiments())
        out += fmt::format("  {:<24} {}\n", experiment.name, experiment.about);
    return out;
}

std::vector<std::string> names_of_experiments() {
    std::vector<std::string> names;
    for (const Experiment& experiment : experiments())
        names.emplace_back(experiment.name);
    return names;
}

std::vector<NamedMeaning> meanings_of_experiments() {
    std::vector<NamedMeaning> meanings;
    for (const Experiment& experiment : experiments())
        meanings.push_back({std::string(experiment.name), std::string(experiment.about)});
    return meanings;
}

const Experiment& find_experiment(const std::string& name) {
    auto found = std::ranges::find(experiments(), name, &Experiment::name);
    if (found == experiments().end())
        throw UserError(unknown_meaning("experiment", name, meanings_of_experiments(),
                                        "the experiments are:\n" + list_experiments()));
    return *found;
}

void require_folder_for_plots(const std::filesystem::path& folder) {
    if (is_standard_stream(folder))
        throw UserError("--plots -: plots are written as files into a folder, not to standard output; name a "
                        "folder");
    require_gnuplot();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    require_writable(folder / "plot.svg");
}

void write_plot(const std::filesystem::path& folder, const std::string& name, const std::string& svg) {
    std::filesystem::path path = folder / (name + ".svg");
    write_whole(path, svg);
    print_out(fmt::format("plot: {}\n", path.string()));
}

void write_plots(const Replay& replay, const std::filesystem::path& folder) {
    if (replay.plots.empty() && replay.drawings.empty())
        print_out("this experiment has no plots\n");
    for (const NamedPlot& plot : replay.plots) {
        write_plot(folder, plot.name, draw_svg(plot.plot));
        write_whole(folder / (plot.name + ".csv"), curves_csv(plot.plot));
    }
    for (const NamedDrawing& drawing : replay.drawings)
        write_plot(folder, drawing.name, drawing.svg);
}

void require_outputs(const ReplayOptions& options) {
    if (!options.json.empty())
        require_writable(options.json);
    if (!options.plots.empty())
        require_folder_for_plots(options.plots);
}

/// Throws UserError for `--against printed` if the experiment has no separate figures as the thesis prints them.
void require_printed(const Experiment& experiment, const ReplayOptions& options) {
    std::vector<std::string_view> having;
    for (const Experiment& each : experiments())
        if (each.has_printed)
            having.push_back(each.name);
    if (options.against == "printed" && !experiment.has_printed)
        throw UserError(fmt::format(
            "--against printed has no effect on {}, whose expected figures are the printed ones; the option affects {}",
            experiment.name, fmt::join(having, ", ")));
}

void require_study(const Experiment& experiment, const ReplayOptions& options) {
    if (experiment.seeds == 0 && (options.seeds != 0 || !options.resume.empty()))
        throw UserError(
            fmt::format("{} has a fixed number of runs, so --seeds and --resume have no effect", experiment.name));
    if (options.resume.empty())
        return;
    if (is_standard_stream(options.resume))
        throw UserError("--resume -: runs are kept in a file and read from it later, so standard output cannot "
                        "be used; name a file");
    require_writable(options.resume);
}

/// Opens the file of --resume, which stores the finished runs. Without this option, the runs are in memory only.
StudyResults results_of(const ReplayOptions& options) {
    const std::string whose =
        fmt::format("replay {} --seed {}, {} {}", options.experiment, options.seed, version, commit);
    const StudySource source{.netlist = whose, .texts = {}, .options = whose, .named_by = ""};
    return options.resume.empty() ? StudyResults(source) : StudyResults(options.resume, source);
}

std::size_t number_of_seeds(const Experiment& experiment, const ReplayOptions& options) {
    return options.seeds != 0 ? options.seeds : experiment.seeds;
}

/// Runs the experiment. Throws UnfinishedRun if a run does not complete or is interrupted.
Replay run_experiment(const Experiment& experiment, const ReplayOptions& options, Interruption& interruption) {
    ProgressLine progress;
    StudyResults results = results_of(options);
    auto show = [&](const std::string& what) {
        end_if_requested(interruption);
        progress.show(what);
    };
    Replay result = experiment.run({examples_folder(), options.seed, show, print_warnings, interruption, results,
                                    number_of_seeds(experiment, options), options.against == "printed"});
    end_if_requested(interruption);
    return result;
}

void write_files(const Replay& replay, const ReplayOptions& options, const std::string& typed) {
    if (!options.json.empty())
        write_whole(options.json, print_pretty(replay_json(replay, options.experiment, options.seed, typed)));
    if (!options.plots.empty())
        write_plots(replay, options.plots);
}

/// Tells the user how to continue an interrupted study.
std::string what_is_left(const ReplayOptions& options, const UnfinishedRun& unfinished) {
    if (unfinished.outcome != RunOutcome::interrupted || find_experiment(options.experiment).seeds == 0)
        return "";
    return options.resume.empty()
               ? "hint: --resume FILE keeps the finished runs\n"
               : fmt::format("{} keeps the finished runs: type the same command again to continue\n", options.resume);
}

ExitCode replay(const ReplayOptions& options, const std::string& typed) try {
    const Experiment& experiment = find_experiment(options.experiment);
    require_study(experiment, options);
    require_printed(experiment, options);
    require_outputs(options);
    require_seeds(options.seed, std::max<std::size_t>(number_of_seeds(experiment, options), 1));
    InterruptedBySignals interruption;
    if (options.seeds > most_unasked && !options.yes && !are_meant({options.seeds, true, 1, {}}, interruption))
        return interruption.requested() ? ExitCode::interrupted : ExitCode::success;
    Replay result = run_experiment(experiment, options, interruption);
    print_out(print_replay(result));
    write_files(result, options, typed);
    return result.within_tolerance() ? ExitCode::success : ExitCode::missed_tolerance;
} catch (const UnfinishedRun& unfinished) {
    print_error(fmt::format("placedpar: {}\n{}", unfinished.what(), what_is_left(options, unfinished)));
    return exit_code_of(unfinished.outcome);
}

Action declare_replay(Options& command, const std::string& typed) {
    auto options = std::make_shared<ReplayOptions>();
    command.add("EXPERIMENT", options->experiment, "one of the experiments below").required();
    add_seed(command, options->seed);
    add_file(command, "--json", options->json, "writes all compared figures as JSON");
    add_file(command, "--plots", options->plots, "writes the experiment's plots (SVG) and their curves (CSV)",
             "FOLDER");
    add_number(command, "--seeds", options->seeds, 1, most_seeds,
               "number of seeds, for experiments that run several; default: the "
               "number that the experiment states");
    add_file(command, "--resume", options->resume,
             "keeps finished runs in this file, and skips the runs that it already has");
    command
        .add("--against", options->against,
             "figures to compare with, where the thesis prints a figure that does not follow from its own "
             "measurements: printed, or expected (the figure that follows)")
        .one_of({"expected", "printed"})
        .show_default();
    command.add_flag("--yes", options->yes, "starts any number of runs without asking");
    command.add_footer("experiments:\n" + list_experiments());
    return [options, typed] { return replay(*options, typed); };
}

} // namespace

extern const Command replay_command{
    .name = "replay",
    .about = "Repeats an experiment of the thesis and compares the figures",
    .place = 60,
    .declare = declare_replay,
    .values = names_of_experiments,
};

} // namespace placedpar
