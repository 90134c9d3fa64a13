#include "gaprocs/policies/individual.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace placedpar {

namespace {

/// Returns the index of the fitness that comes first in the given order; among equals the lowest index. REQUIRES: at
/// least one fitness, and no NaN.
template <class ComesFirst>
std::size_t first_index(std::span<const double> fitness, ComesFirst comes_first) {
    // First finds the value, then its index. Four independent sequences of comparisons are faster than one, in which
    // each comparison would wait for the previous comparison.
    std::array<double, 4> firsts;
    firsts.fill(fitness.front());
    std::size_t i = 0;
    for (; i + firsts.size() <= fitness.size(); i += firsts.size())
        for (std::size_t j = 0; j < firsts.size(); ++j)
            firsts[j] = comes_first(fitness[i + j], firsts[j]) ? fitness[i + j] : firsts[j];
    for (; i < fitness.size(); ++i)
        firsts[0] = comes_first(fitness[i], firsts[0]) ? fitness[i] : firsts[0];
    double first = *std::min_element(firsts.begin(), firsts.end(), comes_first);
    return static_cast<std::size_t>(std::find(fitness.begin(), fitness.end(), first) - fitness.begin());
}

/// Returns the indices of the `count` fitness values that come first in the given order; among equals the lowest index
/// first.
template <class ComesFirst>
std::vector<std::size_t> first_indices(std::span<const double> fitness, std::size_t count, ComesFirst comes_first) {
    if (count == 0)
        return {};
    if (count == 1) // the most frequent case: an elite of one
        return {first_index(fitness, comes_first)};
    std::vector<std::size_t> indices(fitness.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    auto before = [&](std::size_t a, std::size_t b) {
        return fitness[a] != fitness[b] ? comes_first(fitness[a], fitness[b]) : a < b;
    };
    auto end = indices.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(indices.begin(), end, indices.end(), before);
    indices.resize(count);
    return indices;
}

} // namespace

std::size_t best_index(std::span<const double> fitness) { return first_index(fitness, std::greater()); }

std::vector<std::size_t> best_indices(std::span<const double> fitness, std::size_t count) {
    return first_indices(fitness, count, std::greater());
}

std::vector<std::size_t> worst_indices(std::span<const double> fitness, std::size_t count) {
    return first_indices(fitness, count, std::less());
}

bool are_different(std::vector<std::size_t> indices, std::size_t first, std::size_t end) {
    std::ranges::sort(indices);
    return indices.empty() ||
           (indices.front() >= first && indices.back() < end && std::ranges::adjacent_find(indices) == indices.end());
}

} // namespace placedpar
