#pragma once

#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/search_problem.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace placedpar {

/// Objective problems of one name that differ in their numbers, such as "sphere(dimensions = 3, bits = 16)": a struct
/// as in gaprocs/objective_problem.hpp that also has the name, the line about it and the numbers of a policy.
struct ProblemFamily {
    PolicyDescription description;
    /// REQUIRES: as many numbers as described, in their ranges. Throws as the struct's representation().
    std::function<std::shared_ptr<const SearchProblem>(const std::vector<double>& numbers)> make;
};

template <StatesObjective P>
ProblemFamily minimised() {
    return {describe_policy<P>(), [](const std::vector<double>& numbers) { return minimise(make_policy<P>(numbers)); }};
}
template <StatesObjective P>
ProblemFamily maximised() {
    return {describe_policy<P>(), [](const std::vector<double>& numbers) { return maximise(make_policy<P>(numbers)); }};
}

} // namespace placedpar
