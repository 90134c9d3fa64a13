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

/// A problem whose objectives and constraints a function in Python computes. The function receives an array with a row
/// for each individual of a population. It returns an array of objectives, or a tuple of objectives and constraints,
/// each with a row or a number for each individual.
struct FunctionInPython {
    pybind11::object function;
    Bounds bounds;
    std::vector<std::size_t> bits; ///< number of bits for each parameter
    bool maximises;

    /// Throws UserError for bounds that cannot be encoded. REQUIRES: the caller holds Python's global lock whenever the
    /// problem is used.
    std::shared_ptr<const SearchProblem> problem() const;
    /// Returns a description: the goal (minimise or maximise) and the fields.
    std::string text() const;
};

} // namespace placedpar::python
