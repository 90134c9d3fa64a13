#include "python/module/python_problem.hpp"

#include "gaprocs/objective_problem.hpp"
#include "python/module/interpreter.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

namespace placedpar::python {

namespace {

namespace py = pybind11;

/// The parameters of a problem, in the form of a problem without objectives. PythonProblem adds the objectives.
struct Parameters {
    ParameterCoding coding;
    ParameterCoding representation() const { return coding; }
    double objective(std::span<const double>) const { return 0; }
};

using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// An array with a row for each individual.
struct Table {
    Values values;
    std::size_t columns = 0;
    std::vector<double> row(std::size_t i) const {
        const auto all = std::span(values.data(), static_cast<std::size_t>(values.size()));
        const auto part = all.subspan(i * columns, columns);
        return {part.begin(), part.end()};
    }
};

/// The values that a function returned for a population.
struct Rated {
    Table objectives, constraints;
    Merit merit(std::size_t i, Goal goal) const {
        return merit_of(objectives.row(i), violation_of(constraints.row(i)), goal);
    }
};

/// Returns the array that the function returned. Throws UserError unless it has a number, or a row of numbers, for each
/// individual.
Table table_of(const py::object& returned, const py::array& population, const char* what) {
    constexpr std::string_view kinds = "biuf"; // NumPy's whole and real numbers
    const py::array any = py::array::ensure(returned);
    PyErr_Clear();
    if (!any || kinds.find(any.dtype().kind()) == std::string_view::npos)
        throw UserError(
            fmt::format("the {} must be numbers, an array of shape (n,) or (n, k): the function returned {}", what,
                        py::repr(returned).cast<std::string>()));
    const Values values(any);
    const auto count = population.shape(0);
    if ((values.ndim() != 1 && values.ndim() != 2) || values.shape(0) != count || values.size() == 0)
        throw UserError(fmt::format(
            "the {} of a population of shape ({}, {}) must have the shape ({},) or ({}, k), but "
            "have the shape {}",
            what, count, population.shape(1), count, count, py::repr(values.attr("shape")).cast<std::string>()));
    return {values, static_cast<std::size_t>(values.size() / count)};
}

Rated rated_of(const py::object& returned, const py::array& population) {
    if (!py::isinstance<py::tuple>(returned))
        return {table_of(returned, population, "objectives"), {}};
    const auto pair = py::reinterpret_borrow<py::tuple>(returned);
    if (pair.size() != 2)
        throw UserError(
            fmt::format("the function returned a tuple of length {}, expected an array of objectives, or a tuple of "
                        "objectives and constraints",
                        pair.size()));
    return {table_of(pair[0], population, "objectives"), table_of(pair[1], population, "constraints")};
}

/// A problem whose objectives and constraints are a function in Python.
class PythonProblem final : public AdaptedProblem {
public:
    /// `parameters` describes the problem without its objectives. REQUIRES: the caller holds Python's global lock
    /// whenever the problem is used.
    PythonProblem(std::shared_ptr<const SearchProblem> parameters, SharedObject function)
        : AdaptedProblem(std::move(parameters)), function_(std::move(function)) {}

    bool has_constraints() const override { return columns_ && columns_->second > 0; }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        double fitness = 0;
        fitness_of({&genome, 1}, samples, bias, {&fitness, 1});
        return fitness;
    }
    void fitness_of(std::span<const Genome>, std::span<const Sample>, double bias,
                    std::span<double> out) const override;
    std::optional<Merit> merit(const Genome& genome) const override { return merits({&genome, 1}).front(); }
    std::vector<Merit> merits(std::span<const Genome>) const override;
    std::vector<std::string> objective_names() const override;

private:
    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override {
        return std::make_shared<PythonProblem>(problem_->coded(coding), function_);
    }
    Rated rate(std::span<const Genome>) const;

    SharedObject function_;
    mutable std::optional<std::pair<std::size_t, std::size_t>>
        columns_; ///< objectives and constraints of the first call
};

Rated PythonProblem::rate(std::span<const Genome> population) const {
    py::array_t<double> rows({population.size(), problem_->parameter_names().size()});
    double* to = rows.mutable_data();
    for (const Genome& genome : population)
        to = std::ranges::copy(problem_->decode(genome), to).out;
    Rated rated = rated_of(function_.get()(rows), rows);
    const std::pair columns(rated.objectives.columns, rated.constraints.columns);
    if (columns_.value_or(columns) != columns)
        throw UserError(
            fmt::format("the function returned {} objectives and {} constraints for each individual, but {} "
                        "and {} in its first call",
                        columns.first, columns.second, columns_->first, columns_->second));
    columns_ = columns;
    return rated;
}

void PythonProblem::fitness_of(std::span<const Genome> population, std::span<const Sample>, double,
                               std::span<double> out) const {
    const Rated rated = rate(population);
    if (rated.objectives.columns != 1)
        throw UserError(fmt::format("a search has one objective, but the function returned {} for each individual: "
                                    "use search_front() for several objectives",
                                    rated.objectives.columns));
    const Objective objective = *problem_->objective();
    std::ranges::transform(std::span(rated.objectives.values.data(), out.size()), out.begin(),
                           [&](double value) { return objective.fitness(value); });
    for (std::size_t i = 0; has_constraints() && i < out.size(); ++i)
        if (const Merit merit = rated.merit(i, objective.goal); !merit.feasible)
            out[i] = infeasible_fitness(merit.violation);
}

std::vector<Merit> PythonProblem::merits(std::span<const Genome> population) const {
    const Rated rated = rate(population);
    std::vector<Merit> merits;
    for (std::size_t i = 0; i < population.size(); ++i)
        merits.push_back(rated.merit(i, problem_->objective()->goal));
    return merits;
}

std::vector<std::string> PythonProblem::objective_names() const {
    std::vector<std::string> names;
    for (std::size_t i = 1; columns_ && columns_->first > 1 && i <= columns_->first; ++i)
        names.push_back(fmt::format("f_{}", i));
    return names;
}

} // namespace

std::shared_ptr<const SearchProblem> FunctionInPython::problem() const {
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

std::string FunctionInPython::text() const {
    std::string text = maximises ? "maximise a function of" : "minimise a function of";
    for (std::size_t i = 0; i < bounds.size(); ++i)
        text += fmt::format(" {}..{} ({} bits)", bounds[i].first, bounds[i].second, bits.at(i));
    return text;
}

} // namespace placedpar::python
