#pragma once

#include "gaprocs/search_problem.hpp"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::python {

/// The least and the greatest value of each parameter.
using Bounds = std::vector<std::pair<double, double>>;

/// A problem whose objectives, and constraints if it has any, are computed by a function in Python. The function gets a
/// population, an array with a row for each individual. It returns an array of objectives, or a tuple of objectives and
/// constraints, each with a row or a number for each individual.
struct FunctionInPython {
    pybind11::object function;
    Bounds bounds;
    std::vector<std::size_t> bits; ///< of each parameter's field
    bool maximises;

    /// Throws UserError for bounds that give no fields. REQUIRES: the caller holds the lock whenever the problem is
    /// used.
    std::shared_ptr<const SearchProblem> problem() const;
    /// Returns what can be said of the function: the goal and the fields.
    std::string text() const;
};

} // namespace placedpar::python
