#pragma once

#include "runtime/process.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// So many points a path can have: with what is made of them, some 2 Gbyte.
inline constexpr std::size_t most_path_points = 2'000'000;

/// Things that happened, each with what had to happen before it: a tree, of which 0 is the root, the beginning of the
/// run. What none of those leads back to that are still in use is forgotten now and then. Where even the rest is more
/// than it may be, the tree is given up: from then on it knows of each in use when it was, and of the one before it.
class PathPoints {
public:
    using Number = std::uint32_t; ///< of a point
    /// Something that happens: until then, since the point before it, time went by with the activity.
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
    /// Renumbers the points. REQUIRES: each number in use is there once.
    void forget_but(std::span<Number* const> in_use);
    /// Whether the tree was given up.
    bool too_long() const { return too_long_; }

private:
    static constexpr std::size_t least_room = 1 << 16;

    void forget(std::span<Number* const> in_use);
    std::vector<bool> kept(std::span<Number* const> in_use) const;

    std::vector<Point> points_;
    std::size_t most_;
    std::size_t room_; ///< with so many points it is time to forget
    bool too_long_ = false;
};

} // namespace placedpar
