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

// Functions that find individuals by their fitness and return indices.

/// Returns the index of the greatest fitness; the lowest index among equals. REQUIRES: not empty.
std::size_t best_index(std::span<const double> fitness);
/// Indices of the `count` greatest (smallest), the greatest (smallest) first; the lower index first among equals.
/// REQUIRES: count <= fitness.size().
std::vector<std::size_t> best_indices(std::span<const double> fitness, std::size_t count);
std::vector<std::size_t> worst_indices(std::span<const double> fitness, std::size_t count);

/// Returns whether all indices are different, at least `first` and below `end`.
bool are_different(std::vector<std::size_t> indices, std::size_t first, std::size_t end);

} // namespace placedpar
