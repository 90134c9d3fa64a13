#pragma once

#include "gaprocs/search_problem.hpp"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::python {

/// The least and the greatest value of each parameter that a search varies.
using Bounds = std::vector<std::pair<double, double>>;

/// A search problem whose objectives and constraints a function in Python computes. The function receives an array with
/// a row of parameters for each individual of a population. It returns an array of objectives, or a tuple of two
/// arrays, objectives and constraints. Each array has a row or a number for each individual.
struct FunctionInPython {
    pybind11::object function;
    Bounds bounds;
    std::vector<std::size_t> bits; ///< number of bits for each parameter
    bool maximises;

    /// Returns the problem as a genetic search needs it. Throws UserError for bounds that binary strings cannot
    /// represent. REQUIRES: the caller holds Python's global lock whenever the problem is used.
    std::shared_ptr<const SearchProblem> problem() const;
    /// Returns a description: whether the search minimises or maximises, and the parameters in the string.
    std::string text() const;
};

} // namespace placedpar::python
