#include "app/replay_command.hpp"

#include "app/common_options.hpp"
#include "app/progress.hpp"
#include "experiments/kit/examples_folder.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "text/output_file.hpp"
#include "text/standard_output.hpp"
#include "workbench/gnuplot.hpp"
#include "workbench/manifest.hpp"
#include "workbench/netlist_run.hpp"
#include "workbench/run_report.hpp"

#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace placedpar {

namespace {

/// What the command line may say; what is written has no file where it is empty.
struct Options {
    std::string experiment, json, plots;
    std::uint64_t seed = 1;
};

std::string list_experiments() {
    std::string out;
    for (const Experiment& experiment : experiments())
        out += fmt::format("  {:<20} {}\n", experiment.name, experiment.about);
    return out;
}

const Experiment& find_experiment(const std::string& name) {
    auto found = std::ranges::find(experiments(), name, &Experiment::name);
    if (found == experiments().end())
        throw std::runtime_error(
            fmt::format("there is no experiment \"{}\"; there are:\n{}", name, list_experiments()));
    return *found;
}

boost::json::value or_null(std::optional<double> number) {
    return number ? boost::json::value(*number) : boost::json::value(nullptr);
}

boost::json::object cell_json(const Cell& cell, const std::string& against) {
    boost::json::object json{{"row", cell.row},
                             {"column", cell.column},
                             {"unit", cell.unit},
                             {"thesis", against == "thesis" ? or_null(cell.thesis) : nullptr},
                             {"simulated", cell.simulated},
                             {"error_percent", or_null(cell.error_percent())},
                             {"tolerance_percent", or_null(cell.tolerance_in_percent())},
                             {"origin", name_of(cell.origin)}};
    if (against != "thesis")
        json[against] = or_null(cell.thesis);
    if (cell.tolerance)
        json["tolerance"] = *cell.tolerance; // in the cell's unit
    if (cell.at_least)
        json["at_least"] = *cell.at_least;
    if (cell.at_most)
        json["at_most"] = *cell.at_most;
    return json;
}

boost::json::array cells_json(const Reading& reading) {
    boost::json::array cells;
    for (const Cell& cell : reading.cells)
        cells.push_back(cell_json(cell, reading.against));
    return cells;
}

boost::json::object replay_json(const Replay& replay, const std::string& experiment, std::uint64_t seed,
                                const std::string& command) {
    boost::json::array others;
    for (std::size_t i = 1; i < replay.readings.size(); ++i)
        others.push_back(boost::json::object{{"reading", replay.readings[i].name},
                                             {"cells", cells_json(replay.readings[i])},
                                             {"judged", replay.readings[i].judged},
                                             {"within_tolerance", within_tolerance(replay.readings[i])}});
    return {{"experiment", experiment},
            {"version", version},
            {"seed", seed},
            {"fingerprint", hex(replay.fingerprint)},
            {"command", command},
            {"reading", replay.readings.front().name},
            {"cells", cells_json(replay.readings.front())},
            {"within_tolerance", replay.within_tolerance()},
            {"other_readings", std::move(others)}};
}

std::string print_verdict(const Replay& replay) {
    bool others = std::ranges::any_of(replay.readings, &Reading::judged);
    return fmt::format("{} cell{} {}\n", replay.within_tolerance() ? "every judged" : "a",
                       others ? "" : " of the first reading",
                       replay.within_tolerance() ? "is within its tolerance" : "misses its tolerance");
}

void require_folder_for_plots(const std::filesystem::path& folder) {
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

ExitCode replay(const Options& options, const std::string& command_line) {
    const Experiment& experiment = find_experiment(options.experiment);
    if (!options.json.empty())
        require_writable(options.json);
    if (!options.plots.empty())
        require_folder_for_plots(options.plots);
    InterruptGuard guard;
    Progress progress;
    Replay result;
    try {
        result = experiment.run({examples_folder(), options.seed, [&](const std::string& what) {
                                     end_if_interrupted();
                                     progress.show(what);
                                 }});
        end_if_interrupted();
    } catch (const UnfinishedRun& unfinished) {
        progress.clear();
        fmt::print(stderr, "placedpar: {}\n", unfinished.what());
        return exit_code_of(unfinished.ending);
    }
    progress.clear();
    for (const Reading& reading : result.readings)
        print_out(print_reading(reading) + "\n");
    print_out(fmt::format("{}fingerprint: {:016x}\n{}", result.constants, result.fingerprint, print_verdict(result)));
    if (!options.json.empty())
        write_whole(options.json, print_pretty(replay_json(result, options.experiment, options.seed, command_line)));
    if (!options.plots.empty())
        write_plots(result, options.plots);
    return result.within_tolerance() ? ExitCode::success : ExitCode::missed_tolerance;
}

} // namespace

void declare_replay(CLI::App& app, ChosenCommand& chosen, const std::string& command_line) {
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("replay", "Runs an experiment of the thesis beside the thesis's figures");
    command->add_option("EXPERIMENT", options->experiment, "one of those below")->required();
    add_seed(*command, options->seed);
    add_file(*command, "--json", options->json, "writes the cells for machines");
    add_file(*command, "--plots", options->plots, "writes the experiment's plots, SVG", "FOLDER");
    command->footer("experiments:\n" + list_experiments());
    command->callback([&chosen, &command_line, options] {
        chosen = [&command_line, options] { return replay(*options, command_line); };
    });
}

} // namespace placedpar
