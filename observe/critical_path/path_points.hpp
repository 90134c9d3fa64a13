#pragma once

#include "runtime/process.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// The usual limit of the number of points. At this limit, the points and the path computed from them take about 2
/// Gbyte of memory.
inline constexpr std::size_t most_path_points = 2'000'000;

/// Stores the events of a run, each with the event that caused it, to find the critical path. The events form a tree;
/// its root, point 0, is the beginning of the run. To save memory, all points are removed from time to time except the
/// points in use and their direct and indirect causes. If too many points remain, the tree is given up. From then on
/// this object holds only the points in use, and the cause of each of them.
class PathPoints {
public:
    using Number = std::uint32_t; ///< index of a point; forget_but() changes indices
    /// An event. The activity lasted from the event `before` until `at`.
    struct Point {
        Time at;
        Number before;
        Activity activity;
        std::uint32_t subject, place;
    };

    explicit PathPoints(std::size_t most) : most_(most), room_(std::min(most, least_room)) {}

    Number add(const Point& point) {
        points_.push_back(point);
        return static_cast<Number>(points_.size() - 1);
    }
    const Point& operator[](Number number) const { return points_[number]; }
    bool empty() const { return points_.empty(); }

    bool should_forget() const { return points_.size() >= room_; }
    /// Removes all points except the points in use and their causes, and renumbers the rest. REQUIRES: each variable
    /// that holds a number in use is listed exactly once.
    void forget_but(std::span<Number* const> in_use);
    /// Returns whether the tree was given up.
    bool too_long() const { return too_long_; }

private:
    static constexpr std::size_t least_room = 1 << 16;

    void forget(std::span<Number* const> in_use);
    std::vector<bool> kept(std::span<Number* const> in_use) const;

    std::vector<Point> points_;
    std::size_t most_;
    std::size_t room_; ///< number of points at which points are removed next
    bool too_long_ = false;
};

} // namespace placedpar
