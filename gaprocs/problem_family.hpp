#pragma once

#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace placedpar {

/// Settings with which a search can find the parameters of a record of measurements. PlacedPar warns about a netlist
/// with other settings.
struct RecordAdvice {
    std::size_t trials = 0; ///< suitable number of generations after each sample; 0: any number suits
    double bias = 0;        ///< suitable B of eq. 3.9, fitness = sum of B - error^2; 0: the default suits
};

/// A record of measurements that is made only when it is needed, for example by a simulation.
struct RecordToMake {
    std::size_t samples = 0; ///< number of samples that make() will return
    std::function<std::vector<Sample>()> make = nullptr;
    RecordAdvice advice = {};
};

/// Problems that share a name and differ in their numbers, such as "sphere(dimensions = 3, bits = 16)". minimised() and
/// maximised() make a family from a struct that has `name`, `about` and numbers(), like a policy
/// (gaprocs/policies/policy.hpp). The struct is itself an objective problem, rated by a formula instead of measurements
/// (gaprocs/objective_problem.hpp), or its function problem() returns an objective problem. If the problem has
/// constraints, the family has one more number, `penalty`.
struct ProblemFamily {
    PolicyDescription description;
    /// Makes the problem. REQUIRES: `numbers` has a value in range for each number of the description. Throws what the
    /// constructor or representation() of the problem throws.
    std::function<std::shared_ptr<const SearchProblem>(const std::vector<double>& numbers)> make;
    /// Returns how to make the record of the problem when it is needed. Null for objective problems. REQUIRES: what
    /// `make` requires.
    std::function<RecordToMake(const std::vector<double>& numbers)> record = nullptr;
};

/// Returns the problem with these numbers: the struct P itself, or the result of its problem().
template <class P>
auto problem_with(const std::vector<double>& numbers) {
    if constexpr (requires(const P& family) { family.problem(); })
        return make_policy<P>(numbers).problem();
    else
        return make_policy<P>(numbers);
}

template <class P>
ProblemFamily family_with(Goal goal) {
    using Problem = decltype(problem_with<P>({}));
    PolicyDescription description = describe_policy<P>();
    if constexpr (StatesConstraints<Problem>)
        description.numbers.push_back({"penalty", 0, 0, 1e100, false,
                                       "how much worse each unit of violation makes the objective; 0: every feasible "
                                       "individual is better than every infeasible individual"});
    return {std::move(description), [goal](const std::vector<double>& numbers) {
                const double penalty = StatesConstraints<Problem> ? numbers.back() : 0;
                return std::make_shared<ObjectiveProblemOf<Problem>>(problem_with<P>(numbers), goal, penalty);
            }};
}

template <class P>
ProblemFamily minimised() {
    return family_with<P>(Goal::minimise);
}
template <class P>
ProblemFamily maximised() {
    return family_with<P>(Goal::maximise);
}

} // namespace placedpar
