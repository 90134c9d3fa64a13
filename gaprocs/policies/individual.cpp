#include "gaprocs/policies/individual.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace placedpar {

namespace {

/// The first `count` indices, of those whose fitness comes first and of equals the lower one.
template <class ComesFirst>
std::vector<std::size_t> first_indices(std::span<const double> fitness, std::size_t count, ComesFirst comes_first) {
    if (count == 0)
        return {};
    if (count == 1) { // the usual elite
        std::size_t first = 0;
        for (std::size_t i = 1; i < fitness.size(); ++i)
            first = comes_first(fitness[i], fitness[first]) ? i : first;
        return {first};
    }
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

std::size_t best_index(std::span<const double> fitness) {
    return static_cast<std::size_t>(std::max_element(fitness.begin(), fitness.end()) - fitness.begin());
}

std::vector<std::size_t> best_indices(std::span<const double> fitness, std::size_t count) {
    return first_indices(fitness, count, std::greater());
}

std::vector<std::size_t> worst_indices(std::span<const double> fitness, std::size_t count) {
    return first_indices(fitness, count, std::less());
}

} // namespace placedpar
