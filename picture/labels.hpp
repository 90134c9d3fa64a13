#pragma once

#include "picture/geometry.hpp"
#include "picture/raster.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// Finds room for small labels, on none of the boxes and on no other label; where it can, on no wire of others.
class LabelRoom {
public:
    explicit LabelRoom(const std::vector<Box>& boxes);

    /// A piece of the wire of this number.
    void add_wire(std::size_t wire, const Path&);
    /// Beside the wire's end that the path begins with.
    std::optional<Box> beside_start(std::size_t wire, const Path&, double width, double height);
    /// On the wire, about the middle of its longest line.
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

/// Where a path's longest line begins: the position of that point.
std::size_t longest_line(const Path&);

} // namespace placedpar::picture
