#include "python/module/interpreter.hpp"
#include "python/module/module.hpp"

#include "explore/checkpoint_file.hpp"
#include "explore/problems.hpp"
#include "gaprocs/front_search.hpp"
#include "gaprocs/generation_log.hpp"
#include "gaprocs/islands.hpp"
#include "gaprocs/usual_settings.hpp"
#include "python/module/callables.hpp"
#include "python/module/given.hpp"
#include "python/module/python_problem.hpp"
#include "python/module/signals.hpp"
#include "report/convergence.hpp"
#include "report/search_log.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace placedpar::python {

namespace {

namespace py = pybind11;

py::dict dict_of(const SearchProblem& problem, const SearchResult& found) {
    const Estimate& best = found.best();
    py::dict described;
    described["x"] = py::array_t<double>(static_cast<py::ssize_t>(best.parameters.size()), best.parameters.data());
    described["string"] = problem.representation().text(best.best.genome);
    described["fitness"] = best.best.fitness;
    const auto objective = problem.objective();
    described["value"] = objective ? objective->value(best.best.fitness) : std::optional(best.best.fitness);
    described["violation"] = problem.has_constraints() ? problem.merit(best.best.genome)->violation : 0;
    described["generation"] = best.sample + 1;
    described["generations"] = found.generations;
    return described;
}

struct SearchOptions {
    std::size_t islands, generations;
    std::uint64_t seed;
    std::string coding;
    py::dict settings;
    std::string checkpoint; ///< file in which the search is stored from time to time; "": not stored
    py::object progress;
};

/// A problem that the Python program names, or defines by a function.
struct GivenProblem {
    std::string text; ///< the problem's description in a checkpoint
    std::shared_ptr<const SearchProblem> problem;
    std::optional<RecordedProblem> recorded; ///< no value if the problem is a function
};

GivenProblem given_problem(const FunctionInPython& given, std::uint64_t seed) {
    if (!py::isinstance<py::str>(given.function))
        return {given.text(), given.problem(), std::nullopt};
    const auto name = given.function.cast<std::string>();
    const RecordedProblem recorded = known_problems(seed).find(name);
    return {name, recorded.problem(), recorded};
}

/// Pauses the search between two generations, so that Ctrl-C, the end of Python and other threads can take effect.
class Pauses {
public:
    /// `progress` is None, or a function that receives the number of completed generations and the number of all
    /// generations.
    Pauses(py::object progress, std::uint64_t all) : progress_(std::move(progress)), all_(all) {}
    void pause(std::uint64_t made) {
        if (!progress_.is_none())
            progress_(made, all_);
        { const py::gil_scoped_release turn_of_other_threads; }
        heed_signals();
        if (interruption_.requested())
            throw UserError("the search was stopped because Python is exiting");
    }

private:
    py::object progress_;
    std::uint64_t all_;
    InterruptedByKeyboard interruption_{false};
};

/// Passes the events of the search to a log, and pauses after each generation.
class HeedfulLog final : public SearchObserver {
public:
    explicit HeedfulLog(const SearchOptions& options)
        : log(island_names(options.islands)), pauses_(options.progress, options.islands * options.generations) {}
    void observe(const ObservedGeneration& event) override {
        log.observe(event);
        std::uint64_t& last = last_[std::string(event.search)];
        made_ += event.number - std::exchange(last, event.number); // includes the generations before a checkpoint
        pauses_.pause(made_);
    }
    void observe(const ObservedMigration& event) override { log.observe(event); }
    void observe(const ObservedAnswer& event) override { log.observe(event); }

    GenerationLog log;

private:
    Pauses pauses_;
    std::map<std::string, std::uint64_t> last_; ///< the newest generation of each island
    std::uint64_t made_ = 0;
};

/// Runs the search on the problem's record, or for `generations` generations if the problem has no record.
IslandsResult run(const SearchProblem& problem, const std::optional<RecordedProblem>& recorded,
                  const SearchOptions& options, const IslandsSettings& settings, SearchObserver& observer,
                  Checkpoints* checkpoints) {
    auto streams = island_streams(options.seed, settings.islands.size());
    if (recorded && !problem.objective())
        return run_islands(problem, recorded->record(), settings, std::move(streams), &observer, checkpoints);
    return run_islands(problem, options.generations, settings, std::move(streams), &observer, checkpoints);
}

/// Returns the checkpoint file of the search. Returns null if the options name none.
std::unique_ptr<CheckpointFile> checkpoint_of(const SearchOptions& options, const std::string& text,
                                              const SearchProblem& problem, const std::vector<std::string>& names,
                                              std::size_t population) {
    constexpr std::uint64_t every = 10; // generations between two checkpoints, as in `placedpar run`
    if (options.checkpoint.empty())
        return nullptr;
    std::vector<KeptSearch> searches;
    for (const std::string& name : names)
        searches.push_back({name,
                            {{"problem", text},
                             {"bits", std::to_string(problem.bits())},
                             {"coding", options.coding},
                             {"population", std::to_string(population)}}});
    return std::make_unique<CheckpointFile>(options.checkpoint, std::move(searches), options.seed, every);
}

IslandsSettings settings_of(const SearchProblem& problem, const SearchOptions& options, const PolicyFailure& failure) {
    if (options.islands == 0)
        throw UserError("there are 0 islands, expected at least 1");
    IslandsSettings settings;
    settings.islands.assign(options.islands, usual_settings(problem));
    for (const auto& [name, value] : options.settings)
        change(settings, name.cast<std::string>(), py::reinterpret_borrow<py::object>(value), failure);
    return settings;
}

py::dict search(const GivenProblem& given, const SearchOptions& options) {
    const auto problem = given.problem->coded(Coding::named(options.coding));
    const auto failure = std::make_shared<SharedObject>();
    const IslandsSettings settings = settings_of(*problem, options, failure);
    HeedfulLog observer(options);
    const auto checkpoint = checkpoint_of(options, given.text, *problem, island_names(options.islands),
                                          settings.islands.front().population);
    if (checkpoint)
        observer.log.continue_from(*checkpoint);
    try {
        const IslandsResult result = run(*problem, given.recorded, options, settings, observer, checkpoint.get());
        py::list islands;
        for (const SearchResult& each : result.islands)
            islands.append(dict_of(*problem, each));
        py::dict found;
        found["islands"] = islands;
        found["migrations"] = result.migrations.size();
        found["log_csv"] = log_csv(std::vector<SeededLog>{{options.seed, observer.log}});
        return found;
    } catch (const std::exception& error) {
        if (failure->get())
            rethrow(*failure, "Error", error.what());
        throw;
    }
}

/// Searches with several objectives, and returns the Pareto front as lists: `x` (parameters) and `values` (objectives)
/// with a row for each individual.
py::dict search_front(const GivenProblem& given, const SearchOptions& options) {
    const auto problem = given.problem->coded(Coding::named(options.coding));
    const auto population = python::given<std::size_t>(options.settings["population"], "population");
    const auto checkpoint = checkpoint_of(options, given.text, *problem, {"front"}, population);
    Pauses pauses(options.progress, options.generations);
    const FrontResult result = placedpar::search_front(
        *problem, options.generations, front_settings(problem->representation(), 2 * population),
        RandomStream(options.seed, "front"), [&](std::uint64_t made) { pauses.pause(made); }, checkpoint.get());
    py::list x, strings, values;
    for (const FrontIndividual& each : result.front) {
        x.append(each.parameters);
        strings.append(problem->representation().text(each.genome));
        values.append(each.objectives);
    }
    const auto names = problem->objective_names();
    py::dict found;
    found["x"] = x;
    found["strings"] = strings;
    found["values"] = values;
    found["names"] = names.empty() ? std::vector<std::string>{"f_1"} : names;
    found["parameters"] = problem->parameter_names().size();
    found["least_violation"] = result.least_violation;
    found["evaluations"] = result.evaluations;
    return found;
}

/// The runs with one setting: the setting's name, the first generation, and for each run its values from this
/// generation on.
using RunsOfSetting = std::tuple<std::string, std::uint64_t, std::vector<std::vector<double>>>;

/// Draws for each setting the median and the quartiles of its runs over the generations.
std::string convergence_svg(const std::string& title, const std::vector<RunsOfSetting>& settings, bool logarithmic) {
    std::vector<ConvergenceCurve> curves;
    for (const auto& [name, first, runs] : settings)
        curves.push_back({.name = name, .runs = runs, .colour = static_cast<int>(curves.size()), .first = first});
    Panel panel = convergence_panel(title, "best so far", curves);
    if (panel.series.empty())
        throw UserError("nothing to draw: no value is a finite number");
    panel.y.logarithmic = logarithmic;
    return draw_svg({"", {std::move(panel)}});
}

} // namespace

void add_searches(py::module_& module) {
    const auto add = [&module](const char* name, py::dict (*make)(const GivenProblem&, const SearchOptions&)) {
        module.def(name, [make](py::object problem, Bounds bounds, Given<std::vector<std::size_t>, "bits"> bits,
                                Given<bool, "maximise"> maximises, Given<std::size_t, "islands"> islands,
                                Given<std::size_t, "generations"> generations, std::uint64_t seed,
                                Given<std::string, "coding"> coding, py::dict settings, std::string checkpoint,
                                py::object progress) {
            return make(given_problem({problem, bounds, bits, maximises}, seed),
                        {islands, generations, seed, coding, settings, checkpoint, progress});
        });
    };
    add("search", search);
    add("search_front", search_front);
    module.def("convergence_svg", convergence_svg);
}

} // namespace placedpar::python
