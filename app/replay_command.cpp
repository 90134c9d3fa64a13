#include "app/replay_command.hpp"

#include "app/examples_folder.hpp"
#include "app/experiment.hpp"
#include "app/experiment_runs.hpp"
#include "app/manifest.hpp"
#include "app/netlist_run.hpp"
#include "app/output_file.hpp"
#include "app/progress.hpp"
#include "app/run_report.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar {

namespace {

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

boost::json::array cells_json(const Reading& reading) {
    boost::json::array cells;
    for (const Cell& cell : reading.cells)
        cells.push_back(boost::json::object{{"row", cell.row},
                                            {"column", cell.column},
                                            {"unit", cell.unit},
                                            {"thesis", or_null(cell.thesis)},
                                            {"simulated", cell.simulated},
                                            {"error_percent", or_null(cell.error_percent())},
                                            {"tolerance_percent", or_null(cell.tolerance_percent)},
                                            {"origin", name_of(cell.origin)}});
    return cells;
}

bool within_tolerance(const Reading& reading) { return std::ranges::all_of(reading.cells, &Cell::within_tolerance); }

boost::json::object replay_json(const Replay& replay, const std::string& experiment, std::uint64_t seed,
                                const std::string& command) {
    boost::json::array others;
    for (std::size_t i = 1; i < replay.readings.size(); ++i)
        others.push_back(boost::json::object{{"reading", replay.readings[i].name},
                                             {"cells", cells_json(replay.readings[i])},
                                             {"within_tolerance", within_tolerance(replay.readings[i])}});
    return {{"experiment", experiment},
            {"version", version},
            {"seed", seed},
            {"fingerprint", hex(replay.fingerprint)},
            {"command", command},
            {"reading", replay.readings.front().name},
            {"cells", cells_json(replay.readings.front())},
            {"within_tolerance", within_tolerance(replay.readings.front())},
            {"other_readings", std::move(others)}};
}

} // namespace

std::string list_experiments() {
    std::string out;
    for (const Experiment& experiment : experiments())
        out += fmt::format("  {:<10} {}\n", experiment.name, experiment.about);
    return out;
}

ExitCode replay(const std::string& name, std::uint64_t seed, const std::filesystem::path& json,
                const std::string& command) {
    const Experiment& experiment = find_experiment(name);
    if (!json.empty())
        require_writable(json);
    InterruptGuard guard;
    Progress progress;
    Replay result;
    try {
        result = experiment.run({examples_folder(), seed, [&](const std::string& what) { progress.show(what); }});
    } catch (const UnfinishedRun& unfinished) {
        progress.clear();
        fmt::print(stderr, "placedpar: {}\n", unfinished.what());
        return exit_code_of(unfinished.ending);
    }
    progress.clear();
    for (const Reading& reading : result.readings)
        fmt::print("{}\n", print_reading(reading));
    fmt::print("{}fingerprint: {:016x}\n", result.constants, result.fingerprint);
    bool good = within_tolerance(result.readings.front());
    fmt::print("{}\n", good ? "every judged cell of the first reading is within its tolerance"
                            : "a cell of the first reading misses its tolerance");
    if (!json.empty())
        write_whole(json, print_pretty(replay_json(result, name, seed, command)));
    return good ? ExitCode::success : ExitCode::missed_tolerance;
}

} // namespace placedpar
