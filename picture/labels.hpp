#pragma once

#include "picture/geometry.hpp"
#include "picture/raster.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// Finds room for small labels in the drawing of a network. A label overlaps no box and no other label. If possible, it
/// overlaps no wire except the wire that it labels.
class LabelRoom {
public:
    explicit LabelRoom(const std::vector<Box>& boxes);

    /// Adds a part of wire number `wire`, which labels of other wires avoid.
    void add_wire(std::size_t wire, const Path&);
    /// Finds room beside the first point of the path, at the wire's end.
    std::optional<Box> beside_start(std::size_t wire, const Path&, double width, double height);
    /// Finds room on the wire, near the middle of the path's longest line.
    std::optional<Box> on_middle(std::size_t wire, const Path&, double width, double height);

private:
    struct Line {
        std::size_t wire;
        Point from, to;
    };
    using Tile = std::pair<int, int>;

    template <class Visit>
    static void each_tile(const Box&, Visit);
    void take(const Box&);
    bool is_free(const Box&) const;
    bool is_crossed(const Box&, std::size_t but_for) const;
    std::optional<Box> first_free(const std::vector<Box>& candidates, std::size_t wire);

    std::map<Tile, std::vector<Box>> taken_;
    std::map<Tile, std::vector<Line>> lines_;
};

/// Returns the index of the point at which the longest line of a path begins.
std::size_t longest_line(const Path&);

} // namespace placedpar::picture
