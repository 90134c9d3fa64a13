#pragma once

#include "picture/geometry.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::picture {

/// A way of straight lines, from its first point to its last.
using Path = std::vector<Point>;

/// A border point of a box, and the direction in which a wire leaves the box there: one unit across or down.
struct Port {
    Point at, outward;
};

/// Finds ways for wires around boxes, on points that are a pitch apart (boxes.hpp). Wires cross, but none runs along
/// another.
class Raster {
public:
    /// REQUIRES: the borders of the boxes lie on the raster.
    Raster(const Box& area, const std::vector<Box>& boxes);

    /// Nothing leads through it.
    void block(const Box&);
    /// A wire is there.
    void add(const Path&);
    /// From one of the ports to one of the others; none where there is no way, or after a very long search.
    std::optional<Path> find(const std::vector<Port>& from, const std::vector<Port>& to);

private:
    class Search;
    /// What is known of a point: a box or a label is there or close by, or wires are, by their direction.
    struct Mark {
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
    std::vector<Mark> marks_; ///< none where there are too many points
    std::size_t steps_left_;
    std::vector<unsigned> costs_;       ///< by state of a search; between searches of none
    std::vector<unsigned char> before_; ///< by state: the way by which the point before was reached
};

} // namespace placedpar::picture
