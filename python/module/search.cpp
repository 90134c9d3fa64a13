#include "python/module/interpreter.hpp"
#include "python/module/module.hpp"

#include "explore/checkpoint_file.hpp"
#include "explore/problems.hpp"
#include "gaprocs/front_search.hpp"
#include "gaprocs/generation_log.hpp"
#include "gaprocs/islands.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/usual_settings.hpp"
#include "python/module/callables.hpp"
#include "python/module/given.hpp"
#include "python/module/signals.hpp"
#include "report/search_log.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::python {

namespace {

namespace py = pybind11;
using namespace pybind11::literals;

/// The parameters of a problem whose objective is computed elsewhere.
struct Parameters {
    ParameterCoding coding;
    ParameterCoding representation() const { return coding; }
    double objective(std::span<const double>) const { return 0; }
};

/// A problem whose objective is a function in Python. The function gets a population at a time, as an array with a row
/// for each individual.
class PythonProblem final : public AdaptedProblem {
public:
    /// `parameters` knows all but the objective. REQUIRES: the caller holds the lock whenever the problem is used.
    PythonProblem(std::shared_ptr<const SearchProblem> parameters, SharedObject function)
        : AdaptedProblem(std::move(parameters)), function_(std::move(function)) {}

    std::optional<Merit> merit(const Genome&) const override { return std::nullopt; }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        double fitness = 0;
        fitness_of({&genome, 1}, samples, bias, {&fitness, 1});
        return fitness;
    }
    void fitness_of(std::span<const Genome>, std::span<const Sample>, double bias,
                    std::span<double> out) const override;

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override {
        return std::make_shared<PythonProblem>(problem_->coded(coding), function_);
    }

    SharedObject function_;
};

using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns what an objective returned as an array. Throws UserError for anything but real numbers.
Values numbers_of(const py::object& returned) {
    constexpr std::string_view kinds = "biuf"; // NumPy's whole and real numbers
    const py::array any = py::array::ensure(returned);
    if (any && kinds.find(any.dtype().kind()) != std::string_view::npos)
        if (Values values = Values::ensure(any))
            return values;
    PyErr_Clear();
    throw UserError("the objective must return numbers, an array of shape (n,): it returned " +
                    py::repr(returned).cast<std::string>());
}

void PythonProblem::fitness_of(std::span<const Genome> population, std::span<const Sample>, double,
                               std::span<double> out) const {
    const std::size_t columns = problem_->parameter_names().size();
    py::array_t<double> rows({population.size(), columns});
    double* to = rows.mutable_data();
    for (const Genome& genome : population)
        to = std::ranges::copy(problem_->decode(genome), to).out;
    const py::object returned = function_.get()(rows);
    const Values values = numbers_of(returned);
    const auto count = static_cast<py::ssize_t>(population.size());
    if (values.ndim() == 0 || values.shape(0) != count || values.size() != count)
        throw UserError("the objective of a population of shape (" + std::to_string(population.size()) + ", " +
                        std::to_string(columns) + ") must have one number for each row, but has the shape " +
                        py::repr(values.attr("shape")).cast<std::string>());
    const Objective objective = *problem_->objective();
    std::ranges::transform(std::span(values.data(), population.size()), out.begin(),
                           [&](double value) { return objective.fitness(value); });
}

using Bounds = std::vector<std::pair<double, double>>;

std::shared_ptr<const SearchProblem> problem_of(const py::object& function, const Bounds& bounds,
                                                const std::vector<std::size_t>& bits, bool maximises) {
    std::vector<ParameterField> fields;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        fields.push_back({.low = bounds[i].first, .high = bounds[i].second, .bits = bits.at(i)});
    try {
        Parameters parameters{ParameterCoding(std::move(fields))};
        return std::make_shared<PythonProblem>(maximises ? maximise(parameters) : minimise(parameters),
                                               SharedObject(function));
    } catch (const std::invalid_argument& error) {
        throw UserError(std::string("bounds: ") + error.what());
    }
}

py::dict dict_of(const SearchProblem& problem, const SearchResult& found) {
    const Estimate& best = found.best();
    const double fitness = best.best.fitness;
    const auto objective = problem.objective();
    const auto parameters = static_cast<py::ssize_t>(best.parameters.size());
    return py::dict("x"_a = py::array_t<double>(parameters, best.parameters.data()),
                    "string"_a = problem.representation().text(best.best.genome), "fitness"_a = fitness,
                    "value"_a = objective ? objective->value(fitness) : std::optional(fitness),
                    "generation"_a = best.sample + 1, "generations"_a = found.generations);
}

struct SearchOptions {
    std::size_t islands, generations;
    std::uint64_t seed;
    std::string coding;
    py::dict settings;      ///< of all islands, by their names
    std::string checkpoint; ///< a file; "" for none
    std::string problem;    ///< what a checkpoint says of the problem
    py::object progress;
};

/// Returns what can be said of a function: the goal and the fields.
std::string text_of(const Bounds& bounds, const std::vector<std::size_t>& bits, bool maximises) {
    std::string text = maximises ? "maximise a function of" : "minimise a function of";
    for (std::size_t i = 0; i < bounds.size(); ++i)
        text += fmt::format(" {}..{} ({} bits)", bounds[i].first, bounds[i].second, bits.at(i));
    return text;
}

/// Keeps the log, and lets Ctrl-C, the end of Python and other threads come between two generations.
class HeedfulLog final : public GenerationLog {
public:
    /// `progress` is None, or is called with the numbers of generations that all islands have made and will make.
    explicit HeedfulLog(const SearchOptions& options)
        : GenerationLog(island_names(options.islands)), progress_(options.progress),
          all_(options.islands * options.generations) {}
    using GenerationLog::observe;
    void observe(const ObservedGeneration& event) override {
        GenerationLog::observe(event);
        std::uint64_t& last = last_[std::string(event.search)];
        made_ += event.number - std::exchange(last, event.number); // a checkpoint's generations count, too
        if (!progress_.is_none())
            progress_(made_, all_);
        { const py::gil_scoped_release turn_of_other_threads; }
        heed_signals();
        if (interruption_.requested())
            throw UserError("the search ends early, since Python ends");
    }

private:
    py::object progress_;
    std::map<std::string, std::uint64_t> last_; ///< the newest generation of each island
    std::uint64_t made_ = 0, all_;
    InterruptedByKeyboard interruption_{false};
};

/// Runs the search on the record of the problem, or for so many generations if it has none.
IslandsResult run(const SearchProblem& problem, const RecordedProblem* recorded, std::size_t generations,
                  const IslandsSettings& settings, std::uint64_t seed, SearchObserver& observer,
                  Checkpoints* checkpoints) {
    auto streams = island_streams(seed, settings.islands.size());
    if (recorded && !problem.objective())
        return run_islands(problem, recorded->record(), settings, std::move(streams), &observer, checkpoints);
    return run_islands(problem, generations, settings, std::move(streams), &observer, checkpoints);
}

/// Returns the file that keeps the search; nothing if none is asked for.
std::unique_ptr<CheckpointFile> checkpoint_of(const SearchOptions& options, const SearchProblem& problem,
                                              const IslandsSettings& settings) {
    constexpr std::uint64_t every = 10; // generations, as in `placedpar run`
    if (options.checkpoint.empty())
        return nullptr;
    std::vector<KeptSearch> searches;
    for (const std::string& name : island_names(settings.islands.size()))
        searches.push_back({name,
                            {{"problem", options.problem},
                             {"bits", std::to_string(problem.bits())},
                             {"coding", options.coding},
                             {"population", std::to_string(settings.islands.front().population)}}});
    return std::make_unique<CheckpointFile>(options.checkpoint, std::move(searches), options.seed, every);
}

IslandsSettings settings_of(const SearchProblem& problem, const SearchOptions& options, const PolicyFailure& failure) {
    IslandsSettings settings;
    settings.islands.assign(options.islands, usual_settings(problem));
    for (const auto& [name, value] : options.settings)
        change(settings, name.cast<std::string>(), py::reinterpret_borrow<py::object>(value), failure);
    return settings;
}

py::dict search(const SearchProblem& coded, const RecordedProblem* recorded, const SearchOptions& options) {
    const auto problem = coded.coded(Coding::named(options.coding));
    const auto failure = std::make_shared<SharedObject>();
    const IslandsSettings settings = settings_of(*problem, options, failure);
    HeedfulLog observer(options);
    const auto checkpoint = checkpoint_of(options, *problem, settings);
    try {
        const IslandsResult result =
            run(*problem, recorded, options.generations, settings, options.seed, observer, checkpoint.get());
        py::list islands;
        for (const SearchResult& each : result.islands)
            islands.append(dict_of(*problem, each));
        return py::dict("islands"_a = islands, "migrations"_a = result.migrations.size(),
                        "log_csv"_a = log_csv(std::vector<SeededLog>{{options.seed, observer}}));
    } catch (const std::exception& error) {
        if (failure->get())
            rethrow(*failure, "Error", error.what());
        throw;
    }
}

/// Returns the front as arrays: `x` and `values` with a row for each individual.
py::dict search_front_of(const std::string& name, std::size_t generations, std::size_t population, std::uint64_t seed,
                         const std::string& coding) {
    const ProblemRegistry problems = known_problems(seed);
    const auto problem = problems.find(name).problem()->coded(Coding::named(coding));
    const FrontResult result = search_front(
        *problem, generations, front_settings(problem->representation(), 2 * population), RandomStream(seed, "front"));
    py::list x, values;
    for (const FrontIndividual& each : result.front) {
        x.append(each.parameters);
        values.append(each.objectives);
    }
    return py::dict("x"_a = x, "values"_a = values, "names"_a = problem->objective_names(),
                    "least_violation"_a = result.least_violation, "evaluations"_a = result.evaluations);
}

} // namespace

void add_searches(py::module_& module) {
    module.def("search",
               [](const py::object& problem, const Bounds& bounds, const std::vector<std::size_t>& bits, bool maximises,
                  Given<std::size_t, "islands"> islands, Given<std::size_t, "generations"> generations,
                  std::uint64_t seed, Given<std::string, "coding"> coding, py::dict settings, std::string checkpoint,
                  py::object progress) {
                   const bool is_named = py::isinstance<py::str>(problem);
                   const std::string text = is_named ? problem.cast<std::string>() : text_of(bounds, bits, maximises);
                   const SearchOptions options{islands,  generations, seed, coding,
                                               settings, checkpoint,  text, std::move(progress)};
                   if (!is_named)
                       return search(*problem_of(problem, bounds, bits, maximises), nullptr, options);
                   const ProblemRegistry problems = known_problems(seed);
                   const RecordedProblem& recorded = problems.find(problem.cast<std::string>());
                   return search(*recorded.problem(), &recorded, options);
               });
    module.def("search_front", &search_front_of);
}

} // namespace placedpar::python
