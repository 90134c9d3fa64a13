#pragma once

#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace placedpar {

/// Settings that suit a record. The user is warned of other settings.
struct RecordAdvice {
    std::size_t trials =
        0;           ///< generations per sample, if the record's own time is counted in generations; 0: any number
    double bias = 0; ///< B of eq. 3.9, if its order of magnitude differs from the thesis's; 0: the thesis's B
};

/// A record of measurements that takes time to make, for example by a simulation.
struct RecordToMake {
    std::size_t samples = 0; ///< number of samples that make() returns, known before make() is called
    std::function<std::vector<Sample>()> make = nullptr;
    RecordAdvice advice = {};
};

/// Problems that share a name and differ in their numbers, such as "sphere(dimensions = 3, bits = 16)". A family of
/// objective problems is made from a struct with the name, the `about` line and the numbers of a policy. The struct is
/// itself an objective problem (gaprocs/objective_problem.hpp), or its function problem() returns one. Problems with a
/// record also state how the record is made.
struct ProblemFamily {
    PolicyDescription description;
    /// Makes the problem. REQUIRES: one number for each number of the description, each in its range. Throws as the
    /// struct's representation().
    std::function<std::shared_ptr<const SearchProblem>(const std::vector<double>& numbers)> make;
    /// Returns a way to make the record. Null for objective problems. REQUIRES: as for `make`.
    std::function<RecordToMake(const std::vector<double>& numbers)> record = nullptr;
};

/// Returns the problem for these numbers: the struct itself, or the result of its problem().
template <class P>
auto problem_with(const std::vector<double>& numbers) {
    if constexpr (requires(const P& family) { family.problem(); })
        return make_policy<P>(numbers).problem();
    else
        return make_policy<P>(numbers);
}

template <class P>
ProblemFamily minimised() {
    return {describe_policy<P>(),
            [](const std::vector<double>& numbers) { return minimise(problem_with<P>(numbers)); }};
}
template <class P>
ProblemFamily maximised() {
    return {describe_policy<P>(),
            [](const std::vector<double>& numbers) { return maximise(problem_with<P>(numbers)); }};
}

} // namespace placedpar
