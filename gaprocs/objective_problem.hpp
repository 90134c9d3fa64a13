#pragma once

#include "gaprocs/objective.hpp"
#include "gaprocs/representation/parameter_coding.hpp"
#include "gaprocs/representation/representation.hpp"
#include "gaprocs/search_problem.hpp"
#include "text/user_error.hpp"

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace placedpar {

// An objective problem rates each individual by one number, the objective, without any measurements. The problem is a
// plain struct such as
//
//     struct Sphere {
//         ParameterCoding representation() const { return ParameterCoding(3, {-5.12, 5.12, 16}); }
//         double objective(std::span<const double> x) const { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; }
//     };
//
// and minimise(Sphere{}) returns a SearchProblem, which a search can solve. The argument of objective() depends on the
// type of representation(): std::span<const double> for a ParameterCoding or a RealVector, const Genome& for a
// BitString, std::span<const std::size_t> for a Permutation. With a ParameterCoding, the search may breed either bits
// or real numbers: see gaprocs/policies/coding.hpp. An objective that is infinite or NaN is worse than every other, so
// objective() may return infinity for an individual that is not allowed.
//
// A problem may also have a function constraints() with the same argument. It returns one number for each constraint;
// the number is at most 0 if the constraint is satisfied. For an equation h(x) = 0 it returns |h(x)| - tolerance. The
// sum of the numbers above 0 is the violation. Every feasible individual (with violation 0) is better than every
// infeasible individual. Of two infeasible individuals, the individual with the lesser violation is better (K. Deb,
// 2000). So as long as no individual of a population is feasible, selection reduces the violation. A penalty above 0
// replaces these rules: the violation times the penalty is added to the objective, or subtracted if the objective is
// maximised. NaN is the greatest violation.
//
// A problem with several objectives has the functions objectives(), in place of objective(), and objective_names(). All
// objectives are minimised, or all are maximised.

/// An objective problem has the functions representation() and objective(). The argument of objective() is the result
/// of representation().decode(). The problem may also have the functions parameter_names(), parameter_units(),
/// objective_unit() and optimum(), the best possible objective. By default the parameters are "x_1", "x_2", ... without
/// units.
template <typename P>
concept StatesOneObjective = requires(const P& problem, const Genome& genome) {
    { problem.objective(problem.representation().decode(genome)) } -> std::convertible_to<double>;
    { problem.representation().bits() } -> std::convertible_to<std::size_t>;
};
template <typename P>
concept StatesObjectives = requires(const P& problem, const Genome& genome) {
    { problem.objectives(problem.representation().decode(genome)) } -> std::convertible_to<std::vector<double>>;
    { problem.objective_names() } -> std::convertible_to<std::vector<std::string>>;
    { problem.representation().bits() } -> std::convertible_to<std::size_t>;
};
template <typename P>
concept StatesObjective = StatesOneObjective<P> || StatesObjectives<P>;
template <typename P>
concept StatesConstraints = requires(const P& problem, const Genome& genome) {
    { problem.constraints(problem.representation().decode(genome)) } -> std::convertible_to<std::vector<double>>;
};

/// Makes a SearchProblem of an objective problem.
template <StatesObjective P>
class ObjectiveProblemOf final : public SearchProblem {
public:
    /// `penalty`: see the top of this file; 0 for none.
    ObjectiveProblemOf(P problem, Goal goal, double penalty = 0)
        : problem_(std::move(problem)),
          representation_(problem_.representation()), objective_{goal, unit(), known_optimum()}, penalty_(penalty) {}
    ObjectiveProblemOf(P problem, Objective objective, double penalty, Coding coding)
        : problem_(std::move(problem)), representation_(problem_.representation()), objective_(std::move(objective)),
          penalty_(penalty), coding_(coding) {}

    std::size_t bits() const override { return representation().bits(); }
    Representation representation() const override {
        if constexpr (by_fields) {
            if (coding_ == Coding::real)
                return representation_.reals();
            return BitString(representation_.bits());
        } else
            return representation_;
    }
    std::size_t channels() const override { return 0; }
    double error(const Genome&, std::span<const double>) const override {
        throw std::logic_error("an objective problem has no error");
    }
    double fitness(const Genome& genome, std::span<const Sample>, double) const override {
        if constexpr (StatesObjectives<P>)
            throw UserError("a problem with several objectives has no fitness: search for its front");
        else if constexpr (StatesConstraints<P>)
            return constrained_fitness(read(genome));
        else
            return objective_.fitness(problem_.objective(read(genome)));
    }
    void fitness_of(std::span<const Genome> population, std::span<const Sample> samples, double bias,
                    std::span<double> out) const override {
        for (std::size_t i = 0; i < population.size(); ++i)
            out[i] = fitness(population[i], samples, bias);
    }
    std::optional<Objective> objective() const override { return objective_; }
    std::vector<std::string> objective_names() const override {
        if constexpr (StatesObjectives<P>)
            return problem_.objective_names();
        return {};
    }
    bool has_constraints() const override { return StatesConstraints<P>; }
    std::optional<Merit> merit(const Genome& genome) const override {
        const auto& x = read(genome);
        if constexpr (StatesObjectives<P>)
            return merit_of(problem_.objectives(x), violation_at(x), objective_.goal);
        else
            return merit_of({problem_.objective(x)}, violation_at(x), objective_.goal);
    }

    /// Returns the numbers that the string codes; empty if the string does not code numbers.
    std::vector<double> decode(const Genome& genome) const override {
        if constexpr (of_numbers)
            return read(genome);
        else
            return {};
    }
    std::vector<std::string> parameter_names() const override {
        if constexpr (requires { problem_.parameter_names(); })
            return problem_.parameter_names();
        std::vector<std::string> names;
        for (std::size_t i = 1; i <= parameters(); ++i)
            names.push_back("x_" + std::to_string(i));
        return names;
    }
    std::vector<std::string> parameter_units() const override {
        if constexpr (requires { problem_.parameter_units(); })
            return problem_.parameter_units();
        return std::vector<std::string>(parameters());
    }

    std::vector<std::size_t> fields() const override {
        if constexpr (by_fields)
            return problem_.representation().fields();
        else
            return {};
    }
    Coding coding() const override { return coding_; }

private:
    using Read = std::remove_cvref_t<decltype(std::declval<const P&>().representation())>;
    static constexpr bool by_fields = std::is_same_v<Read, ParameterCoding>;
    static constexpr bool of_numbers = by_fields || std::is_same_v<Read, RealVector>;

    std::shared_ptr<const SearchProblem> coded_plainly(Coding coding) const override {
        if (!by_fields && coding != Coding::natural)
            refuse_coding(coding);
        return std::make_shared<ObjectiveProblemOf>(problem_, objective_, penalty_, coding);
    }
    double violation_at(const auto& x) const {
        if constexpr (StatesConstraints<P>)
            return violation_of(problem_.constraints(x));
        return 0;
    }
    double constrained_fitness(const auto& x) const {
        const double violation = violation_at(x);
        if (violation > 0 && penalty_ == 0)
            return infeasible_fitness(violation);
        const double worse = penalty_ * violation;
        const double value = problem_.objective(x) + (objective_.goal == Goal::maximise ? -worse : worse);
        return std::isfinite(value) ? objective_.fitness(value)
                                    : infeasible_fitness(std::numeric_limits<double>::infinity());
    }
    std::size_t parameters() const {
        if constexpr (of_numbers)
            return representation_.parameters();
        else
            return 0;
    }
    decltype(auto) read(const Genome& genome) const {
        if constexpr (by_fields)
            return read_fields(genome);
        else
            return representation_.decode(genome);
    }
    std::vector<double> read_fields(const Genome& genome) const {
        if (coding_ == Coding::natural)
            return representation_.decode(genome);
        if (coding_ == Coding::gray)
            return representation_.decode(GrayCoded(genome));
        std::vector<double> values = representation_.reals().decode(genome);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = representation_.field(i).rounded(values[i]);
        return values;
    }
    std::string unit() const {
        if constexpr (requires { problem_.objective_unit(); })
            return std::string(problem_.objective_unit());
        return "";
    }
    std::optional<double> known_optimum() const {
        if constexpr (requires { problem_.optimum(); })
            return problem_.optimum();
        return std::nullopt;
    }

    P problem_;
    Read representation_;
    Objective objective_;
    double penalty_ = 0;
    Coding coding_ = Coding::natural;
};

/// Make a search problem whose objective is minimised or maximised. They throw what P::representation() throws.
/// `penalty`: how much worse each unit of violation makes the objective; 0: feasible individuals are always better (see
/// the top of this file).
template <StatesObjective P>
std::shared_ptr<const SearchProblem> minimise(P problem, double penalty = 0) {
    return std::make_shared<ObjectiveProblemOf<P>>(std::move(problem), Goal::minimise, penalty);
}
template <StatesObjective P>
std::shared_ptr<const SearchProblem> maximise(P problem, double penalty = 0) {
    return std::make_shared<ObjectiveProblemOf<P>>(std::move(problem), Goal::maximise, penalty);
}

} // namespace placedpar
