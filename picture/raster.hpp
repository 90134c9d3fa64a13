#pragma once

#include "picture/geometry.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::picture {

/// A path of straight lines through all points, from the first to the last.
using Path = std::vector<Point>;

/// A border point of a box, and the direction in which a wire leaves the box there: one unit across or down.
struct Port {
    Point at, outward;
};

/// Finds paths for wires around the boxes of a drawn network. The points of the raster are `pitch` pixels apart
/// (boxes.hpp). Wires may cross, but no wire runs along another wire.
class Raster {
public:
    /// REQUIRES: the borders of the boxes lie on the raster.
    Raster(const Box& area, const std::vector<Box>& boxes);

    /// Blocks the box, so that no path leads through it.
    void block(const Box&);
    /// Adds a wire, which paths may cross but not run along.
    void add(const Path&);
    /// Finds a path from one of the ports `from` to one of the ports `to`. Returns nullopt if there is no path, or if
    /// the search takes too long.
    std::optional<Path> find(const std::vector<Port>& from, const std::vector<Port>& to);

private:
    class Search;
    /// What is at a point of the raster: a box or label, the surroundings of a box, or wires in each direction.
    struct Cell {
        bool blocked = false, near = false, across = false, down = false, slanting = false;

        bool has_wire() const { return across || down || slanting; }
    };

    bool holds(std::ptrdiff_t column, std::ptrdiff_t line) const;
    std::size_t index_of(Point) const;
    Point point_of(std::size_t index) const;
    template <class Change>
    void mark(const Box&, Change);

    Point origin_;
    std::ptrdiff_t columns_, lines_;
    std::vector<Cell> marks_; ///< empty if the raster has too many points
    std::size_t steps_left_;
    std::vector<unsigned> costs_;       ///< cost of each state of a search; reset between searches
    std::vector<unsigned char> before_; ///< for each state, the direction in which the preceding point was reached
};

} // namespace placedpar::picture
