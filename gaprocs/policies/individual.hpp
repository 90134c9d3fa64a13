#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

struct Individual {
    Genome genome;
    double fitness = 0;

    friend bool operator==(const Individual&, const Individual&) = default;
};

/// Returns the index of the greatest fitness; among equals the lowest index. REQUIRES: `fitness` is not empty.
std::size_t best_index(std::span<const double> fitness);
/// Return the indices of the `count` best (worst) individuals, the best (worst) first; among equals the lowest index
/// first. REQUIRES: count <= fitness.size().
std::vector<std::size_t> best_indices(std::span<const double> fitness, std::size_t count);
std::vector<std::size_t> worst_indices(std::span<const double> fitness, std::size_t count);

/// Returns whether all indices are different and in the range `first` <= index < `end`.
bool are_different(std::vector<std::size_t> indices, std::size_t first, std::size_t end);

} // namespace placedpar
