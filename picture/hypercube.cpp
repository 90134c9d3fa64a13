#include "picture/hypercube.hpp"

#include "picture/svg_pen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace placedpar {

namespace {

using picture::SvgPen;
using At = picture::Point;

constexpr double cube_margin = 56, note_room = 44, text_line = 17, vertex_radius = 15, caption = 40, legend_height = 34;

/// The displacement, in pixels, from a vertex whose bit is 0 to the vertex whose bit is 1, for each bit. The string's
/// last bit comes first: right, up, back, and to the second cube.
constexpr std::array<At, 4> bit_leads{At{132, 0}, {0, -132}, {74, -62}, {284, 40}};

constexpr const char* hypercube_style =
    R"(text { font-size: 12px; }
.title { font-size: 17px; font-weight: bold; }
.caption { font-size: 14px; font-weight: bold; }
.number { font-size: 13px; text-anchor: middle; font-weight: bold; }
.bits { font-size: 11px; text-anchor: middle; fill: #445566; font-family: "DejaVu Sans Mono", monospace; }
.note { font-size: 12px; font-weight: bold; fill: #8a2f00; }
.over { paint-order: stroke; stroke: #ffffff; stroke-width: 4px; stroke-linejoin: round; }
.link { stroke: #b4bec8; stroke-width: 1.2; }
.spanned { stroke: #0072b2; stroke-width: 3.4; }
.move { stroke: #d55e00; stroke-width: 2; fill: none; }
.empty circle { fill: #ffffff; stroke: #b4bec8; }
.empty .number { fill: #8898a8; font-weight: normal; }
.member circle { fill: #cfe3f3; stroke: #16324a; stroke-width: 1.6; }
.parent circle { fill: #0b4f7d; stroke: #0b4f7d; }
.parent .number { fill: #ffffff; }
.offspring circle { fill: #ffe3cc; stroke: #d55e00; stroke-width: 1.6; }
.offspring .inner { fill: none; }
)";

constexpr const char* head_of_moves =
    R"(<marker id="arrow" viewBox="0 0 10 10" refX="7" refY="5" markerWidth="6" markerHeight="6" )"
    R"(orient="auto-start-reverse"><path d="M0 0 L10 5 L0 10 z" fill="#d55e00"/></marker>)";

/// The size of the drawing of one hypercube, and the place of vertex 0 in the drawing.
struct CubeArea {
    double width, height;
    At zero;
};

At vertex_offset(std::uint32_t vertex, std::size_t dimensions) {
    At at;
    for (std::size_t bit = 0; bit < dimensions; ++bit)
        if ((vertex >> bit & 1u) != 0)
            at = at + bit_leads[bit];
    return at;
}

CubeArea area_of(std::size_t dimensions, std::size_t lines) {
    At least, greatest;
    for (std::uint32_t vertex = 0; vertex < 1u << dimensions; ++vertex) {
        At at = vertex_offset(vertex, dimensions);
        least = {std::min(least.x, at.x), std::min(least.y, at.y)};
        greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y)};
    }
    double below = text_line * static_cast<double>(lines);
    return {greatest.x - least.x + 2 * cube_margin + note_room,
            greatest.y - least.y + 2 * cube_margin + caption + below,
            {cube_margin - least.x, caption + cube_margin - least.y}};
}

const char* class_of(VertexLook look) {
    switch (look) {
    case VertexLook::empty: return "empty";
    case VertexLook::member: return "member";
    case VertexLook::parent: return "parent";
    case VertexLook::offspring: return "offspring";
    }
    return "";
}

/// Draws a vertex. Offspring have a second ring.
SvgPen vertex_symbol(At at, VertexLook look, const std::string& number) {
    SvgPen symbol;
    symbol.circle(at, vertex_radius);
    if (look == VertexLook::offspring)
        symbol.circle(at, vertex_radius - 3.5, {{"class", "inner"}});
    return SvgPen().group({{"class", class_of(look)}}, symbol.text(at + At{0, 4.5}, "number", number));
}

bool is_spanned(const DrawnHypercube& cube, std::uint32_t from, std::uint32_t to) {
    return std::ranges::any_of(cube.spanned, [&](VertexPair corners) {
        std::uint32_t fixed = ~(corners.first ^ corners.second);
        return (from & fixed) == (corners.first & fixed) && (to & fixed) == (corners.first & fixed);
    });
}

/// Draws one hypercube with vertex 0 at the given point.
class CubeDrawing {
public:
    CubeDrawing(SvgPen& pen, const DrawnHypercube& cube, At zero) : pen_(pen), cube_(cube), zero_(zero) {
        links("link");
        links("spanned");
        moves();
        vertices();
    }

private:
    At at(std::uint32_t vertex) const { return zero_ + vertex_offset(vertex, cube_.dimensions); }
    std::uint32_t count() const { return 1u << cube_.dimensions; }

    void links(const std::string& style_class) {
        for (std::uint32_t from = 0; from < count(); ++from)
            for (std::uint32_t bit = 1; bit < count(); bit <<= 1)
                if ((from & bit) == 0 && is_spanned(cube_, from, from | bit) == (style_class == "spanned"))
                    pen_.line(at(from), at(from | bit), {{"class", style_class}});
    }

    void moves() {
        for (auto [from, to] : cube_.moves) {
            At way = at(to) - at(from);
            At unit = (1 / std::max(distance({}, way), 1.0)) * way;
            // Arrows are bent to the side, so that two arrows between the same vertices do not overlap.
            At start = at(from) + vertex_radius * unit, end = at(to) - (vertex_radius + 5) * unit;
            At bend = at(from) + 0.5 * way + 22 * At{-unit.y, unit.x};
            pen_.path("M" + svg_point(start) + " Q" + svg_point(bend) + " " + svg_point(end),
                      {{"class", "move"}, {"marker-end", "url(#arrow)"}});
        }
    }

    void vertices() {
        SvgPen notes;
        for (std::uint32_t vertex = 0; vertex < count(); ++vertex) {
            auto drawn = std::ranges::find(cube_.vertices, vertex, &DrawnVertex::number);
            bool empty = drawn == cube_.vertices.end();
            pen_.add(vertex_symbol(at(vertex), empty ? VertexLook::empty : drawn->look, fmt::format("{}", vertex)));
            pen_.text(at(vertex) + At{0, vertex_radius + 12}, "bits over",
                      fmt::format("{:0{}b}", vertex, cube_.dimensions));
            if (!empty && !drawn->note.empty())
                notes.text(at(vertex) + At{vertex_radius, -vertex_radius + 1}, "note over", drawn->note);
        }
        pen_.add(notes);
    }

    SvgPen& pen_;
    const DrawnHypercube& cube_;
    At zero_;
};

void draw_cube(SvgPen& pen, const DrawnHypercube& cube, At corner) {
    CubeArea area = area_of(cube.dimensions, cube.lines.size());
    pen.text(corner + At{12, 24}, "caption", cube.title);
    CubeDrawing(pen, cube, corner + area.zero);
    double y = area.height - text_line * static_cast<double>(cube.lines.size()) + 4;
    for (const std::string& line : cube.lines) {
        pen.text(corner + At{12, y}, "line", line);
        y += text_line;
    }
}

/// Draws the legend, and returns the x coordinate of its right end.
double draw_legend(SvgPen& pen, const VertexLegend& legend, At at) {
    for (const auto& [look, words] : legend) {
        pen.add(vertex_symbol(at, look, "")).text(at + At{vertex_radius + 8, 4.5}, "line", words);
        at.x += vertex_radius * 2 + 36 + 6.6 * static_cast<double>(words.size());
    }
    return at.x + 26;
}

void require_drawable(const std::vector<DrawnHypercube>& cubes) {
    for (const DrawnHypercube& cube : cubes)
        if (cube.dimensions < 1 || cube.dimensions > bit_leads.size())
            throw std::invalid_argument(
                fmt::format("a hypercube of {} dimensions cannot be drawn, expected 1 to 4", cube.dimensions));
}

} // namespace

std::string draw_hypercubes(const std::string& title, const std::vector<DrawnHypercube>& cubes, std::size_t columns,
                            const VertexLegend& legend) {
    require_drawable(cubes);
    SvgPen pen;
    pen.text({12, 27}, "title", title);
    At corner{0, caption}, end{0, caption};
    double row_height = 0;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
        if (i > 0 && i % columns == 0)
            corner = {0, corner.y + std::exchange(row_height, 0)};
        CubeArea area = area_of(cubes[i].dimensions, cubes[i].lines.size());
        draw_cube(pen, cubes[i], corner);
        corner.x += area.width;
        row_height = std::max(row_height, area.height);
        end = {std::max(end.x, corner.x), corner.y + row_height};
    }
    double height = end.y + (legend.empty() ? 12 : legend_height + 12);
    double width = std::max(end.x, draw_legend(pen, legend, {30, end.y + legend_height / 2}));
    return pen.document({{width / 2, height / 2}, width, height}, hypercube_style, head_of_moves);
}

} // namespace placedpar
