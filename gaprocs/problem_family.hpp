#pragma once

#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace placedpar {

/// Settings that a search over a record should have; a netlist with others is given a warning.
struct RecordAdvice {
    std::size_t trials =
        0;           ///< generations for each sample, if the record's own time is counted in generations; 0: any number
    double bias = 0; ///< B of eq. 3.9, if its order of magnitude differs from that of the thesis; 0: the thesis's
};

/// A record of measurement that takes time to make, such as that of a simulation.
struct RecordToMake {
    std::size_t samples = 0; ///< number of samples that make() returns, known without calling it
    std::function<std::vector<Sample>()> make = nullptr;
    RecordAdvice advice = {};
};

/// Problems of one name that differ in their numbers, such as "sphere(dimensions = 3, bits = 16)". Objective problems:
/// a struct as in gaprocs/objective_problem.hpp that also has the name, the line about it and the numbers of a policy;
/// or a struct with these and a problem() that makes one. Problems with a record say how it is made, too.
struct ProblemFamily {
    PolicyDescription description;
    /// REQUIRES: as many numbers as described, in their ranges. Throws as the struct's representation().
    std::function<std::shared_ptr<const SearchProblem>(const std::vector<double>& numbers)> make;
    /// Returns how to make the record; null for objective problems. REQUIRES: as make.
    std::function<RecordToMake(const std::vector<double>& numbers)> record = nullptr;
};

/// Returns the problem of a struct with these numbers: the struct itself, or the result of its problem().
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
