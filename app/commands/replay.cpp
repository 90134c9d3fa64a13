#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/signals.hpp"
#include "app/standard_error.hpp"
#include "experiments/kit/examples_folder.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "experiments/kit/replay_report.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"
#include "workbench/gnuplot.hpp"
#include "workbench/manifest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// What the command line may say; what is written has no file where it is empty.
struct ReplayOptions {
    std::string experiment, json, plots;
    std::uint64_t seed = 1;
};

std::string list_experiments() {
    std::string out;
    for (const Experiment& experiment : experiments())
        out += fmt::format("  {:<20} {}\n", experiment.name, experiment.about);
    return out;
}

std::vector<std::string> names_of_experiments() {
    std::vector<std::string> names;
    for (const Experiment& experiment : experiments())
        names.emplace_back(experiment.name);
    return names;
}

const Experiment& find_experiment(const std::string& name) {
    auto found = std::ranges::find(experiments(), name, &Experiment::name);
    if (found == experiments().end())
        throw UserError(there_is_no("experiment", name, names_of_experiments(), "there are:\n" + list_experiments()));
    return *found;
}

void require_folder_for_plots(const std::filesystem::path& folder) {
    if (is_standard_stream(folder))
        throw UserError("--plots -: plots are files in a folder; standard output is none");
    require_gnuplot();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    require_writable(folder / "plot.svg");
}

void write_plots(const Replay& replay, const std::filesystem::path& folder) {
    if (replay.plots.empty())
        print_out("this experiment has no plots\n");
    for (const NamedPlot& plot : replay.plots) {
        std::filesystem::path path = folder / (plot.name + ".svg");
        write_whole(path, draw_svg(plot.plot));
        print_out(fmt::format("plot: {}\n", path.string()));
    }
}

void require_outputs(const ReplayOptions& options) {
    if (!options.json.empty())
        require_writable(options.json);
    if (!options.plots.empty())
        require_folder_for_plots(options.plots);
}

/// Throws UnfinishedRun.
Replay run_experiment(const Experiment& experiment, std::uint64_t seed, Interruption& interruption) {
    Progress progress;
    auto show = [&](const std::string& what) {
        end_if_requested(interruption);
        progress.show(what);
    };
    Replay result = experiment.run({examples_folder(), seed, show, print_warnings, interruption});
    end_if_requested(interruption);
    return result;
}

void write_files(const Replay& replay, const ReplayOptions& options, const std::string& typed) {
    if (!options.json.empty())
        write_whole(options.json, print_pretty(replay_json(replay, options.experiment, options.seed, typed)));
    if (!options.plots.empty())
        write_plots(replay, options.plots);
}

ExitCode replay(const ReplayOptions& options, const std::string& typed) try {
    const Experiment& experiment = find_experiment(options.experiment);
    require_outputs(options);
    InterruptedBySignals interruption;
    Replay result = run_experiment(experiment, options.seed, interruption);
    print_out(print_replay(result));
    write_files(result, options, typed);
    return result.within_tolerance() ? ExitCode::success : ExitCode::missed_tolerance;
} catch (const UnfinishedRun& unfinished) {
    fmt::print(stderr, "placedpar: {}\n", unfinished.what());
    return exit_code_of(unfinished.ending);
}

Action declare_replay(CLI::App& command, const std::string& typed) {
    auto options = std::make_shared<ReplayOptions>();
    command.add_option("EXPERIMENT", options->experiment, "one of those below")->required();
    add_seed(command, options->seed);
    add_file(command, "--json", options->json, "writes the cells for machines");
    add_file(command, "--plots", options->plots, "writes the experiment's plots, SVG", "FOLDER");
    command.footer("experiments:\n" + list_experiments());
    return [options, typed] { return replay(*options, typed); };
}

} // namespace

extern const Command replay_command{
    .name = "replay",
    .about = "Runs an experiment of the thesis beside the thesis's figures",
    .place = 5,
    .declare = declare_replay,
    .values = names_of_experiments,
};

} // namespace placedpar
