#include "random_lane.hpp"

#include <algorithm>
#include <functional>

namespace placedpar::test {

bool Lane::is_whole() const {
    auto known = came.empty() ? gone.begin() : std::ranges::upper_bound(gone, came.back());
    return std::ranges::adjacent_find(came, std::ranges::greater_equal()) == came.end() && gone.end() - known <= 1 &&
           std::includes(came.begin(), came.end(), gone.begin(), known);
}

} // namespace placedpar::test
