#include "observe/critical_path/path_points.hpp"

#include <algorithm>

namespace placedpar {

std::vector<bool> PathPoints::kept(std::span<Number* const> in_use) const {
    std::vector<bool> keep(points_.size());
    keep[0] = true;
    for (const Number* number : in_use)
        keep[*number] = keep[points_[*number].before] = true;
    if (!too_long_)
        for (std::size_t i = points_.size(); i-- > 0;)
            if (keep[i])
                keep[points_[i].before] = true;
    return keep;
}

void PathPoints::forget(std::span<Number* const> in_use) {
    const std::vector<bool> keep = kept(in_use);
    std::vector<Number> renumbered(points_.size());
    Number next = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (keep[i]) {
            Point point = points_[i];
            point.before = renumbered[point.before];
            points_[next] = point;
            renumbered[i] = next++;
        }
    points_.resize(next);
    for (Number* number : in_use)
        *number = renumbered[*number];
}

void PathPoints::forget_but(std::span<Number* const> in_use) {
    forget(in_use);
    if (points_.size() > most_ && !too_long_) {
        too_long_ = true;
        forget(in_use);
        points_.shrink_to_fit();
    }
    room_ = std::max(2 * points_.size(), std::min(most_, least_room));
}

} // namespace placedpar
