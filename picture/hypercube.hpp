#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// The appearance of a vertex. The looks differ also in a print without colours.
enum class VertexLook : unsigned char { empty, member, parent, offspring };

/// A vertex of a hypercube, which stands for a binary string. The string, read as a whole number, is the vertex's
/// number: 1100 is vertex 12.
struct DrawnVertex {
    std::uint32_t number;
    VertexLook look = VertexLook::member;
    std::string note = {}; ///< text beside the vertex, such as "2 copies"
};

/// Two vertices: the ends of an arrow, or opposite corners of a smaller hypercube.
using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

/// A hypercube as the thesis draws it (Figures 6.2 to 6.4), to show the binary strings of a population. A link joins
/// two vertices whose strings differ in one bit.
struct DrawnHypercube {
    std::string title;
    std::size_t dimensions = 4;             ///< 1 to 4
    std::vector<DrawnVertex> vertices = {}; ///< vertices that are not listed are drawn as `empty`
    /// Opposite corners of smaller hypercubes, such as two parents. The links of these hypercubes are thick.
    std::vector<VertexPair> spanned = {};
    std::vector<VertexPair> moves = {};  ///< arrows
    std::vector<std::string> lines = {}; ///< lines of text below the drawing
};

using VertexLegend = std::vector<std::pair<VertexLook, std::string>>;

/// Draws hypercubes as SVG, `columns` of them in each row. The same input gives the same bytes. REQUIRES: vertices
/// below 2^dimensions; columns >= 1. Throws std::invalid_argument for dimensions outside 1 to 4.
std::string draw_hypercubes(const std::string& title, const std::vector<DrawnHypercube>& cubes, std::size_t columns,
                            const VertexLegend& legend);

} // namespace placedpar
