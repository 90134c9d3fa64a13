#include "picture/hypercube.hpp"

#include "picture/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace placedpar {

namespace {

using At = picture::Point;

constexpr double cube_margin = 56, note_room = 44, text_line = 17, vertex_radius = 15, caption = 40, legend_height = 34;

/// Where a bit leads, from the last of the string to the first: across, up, into the depth, and to the second cube.
constexpr std::array<At, 4> bit_leads{At{132, 0}, {0, -132}, {74, -62}, {284, 40}};

constexpr const char* hypercube_style =
    R"(text { font-family: Helvetica, Arial, "DejaVu Sans", sans-serif; fill: #16202a; font-size: 12px; }
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

/// The width and height of the drawing of one hypercube, and where vertex 0 stands in it.
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

std::string svg_number(double pixels) { return fmt::format("{}", std::round(pixels * 10) / 10 + 0.0); }

std::string svg_text(At at, const char* style_class, const std::string& text) {
    return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style_class, svg_number(at.x),
                       svg_number(at.y), text);
}

std::string line_between(At from, At to, const char* attributes) {
    return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", svg_number(from.x), svg_number(from.y),
                       svg_number(to.x), svg_number(to.y), attributes);
}

std::string circle_at(At at, double radius, const char* attributes) {
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>", svg_number(at.x), svg_number(at.y),
                       svg_number(radius), attributes);
}

/// Offspring have a second ring.
std::string vertex_symbol(At at, VertexLook look, const std::string& number) {
    std::string inner = look == VertexLook::offspring ? circle_at(at, vertex_radius - 3.5, "class=\"inner\"") : "";
    return fmt::format("<g class=\"{}\">{}{}{}</g>\n", class_of(look), circle_at(at, vertex_radius, ""), inner,
                       svg_text(at + At{0, 4.5}, "number", number));
}

bool is_spanned(const DrawnHypercube& cube, std::uint32_t from, std::uint32_t to) {
    return std::ranges::any_of(cube.spanned, [&](VertexPair corners) {
        std::uint32_t fixed = ~(corners.first ^ corners.second);
        return (from & fixed) == (corners.first & fixed) && (to & fixed) == (corners.first & fixed);
    });
}

/// One drawing, whose vertex 0 stands at a point.
class CubeDrawing {
public:
    CubeDrawing(const DrawnHypercube& cube, At zero) : cube_(cube), zero_(zero) {}

    std::string text() const { return links() + moves() + vertices(); }

private:
    At at(std::uint32_t vertex) const { return zero_ + vertex_offset(vertex, cube_.dimensions); }
    std::uint32_t count() const { return 1u << cube_.dimensions; }

    std::string links() const {
        std::string thin, thick;
        for (std::uint32_t from = 0; from < count(); ++from)
            for (std::uint32_t bit = 1; bit < count(); bit <<= 1)
                if ((from & bit) == 0) {
                    bool spanned = is_spanned(cube_, from, from | bit);
                    (spanned ? thick : thin) +=
                        line_between(at(from), at(from | bit), spanned ? "class=\"spanned\"" : "class=\"link\"");
                }
        return thin + thick;
    }

    std::string moves() const {
        std::string out;
        for (auto [from, to] : cube_.moves) {
            At way = at(to) - at(from);
            At unit = (1 / std::max(distance({}, way), 1.0)) * way;
            // Bent to the side, so that two ways between the same vertices do not lie on each other.
            At start = at(from) + vertex_radius * unit, end = at(to) - (vertex_radius + 5) * unit;
            At bend = at(from) + 0.5 * way + 22 * At{-unit.y, unit.x};
            out += fmt::format("<path class=\"move\" marker-end=\"url(#arrow)\" d=\"M{} {} Q{} {} {} {}\"/>\n",
                               svg_number(start.x), svg_number(start.y), svg_number(bend.x), svg_number(bend.y),
                               svg_number(end.x), svg_number(end.y));
        }
        return out;
    }

    std::string vertices() const {
        std::string out, notes;
        for (std::uint32_t vertex = 0; vertex < count(); ++vertex) {
            auto drawn = std::ranges::find(cube_.vertices, vertex, &DrawnVertex::number);
            bool empty = drawn == cube_.vertices.end();
            out += vertex_symbol(at(vertex), empty ? VertexLook::empty : drawn->look, fmt::format("{}", vertex));
            out += svg_text(at(vertex) + At{0, vertex_radius + 12}, "bits over",
                            fmt::format("{:0{}b}", vertex, cube_.dimensions));
            if (!empty && !drawn->note.empty())
                notes += svg_text(at(vertex) + At{vertex_radius, -vertex_radius + 1}, "note over", drawn->note);
        }
        return out + notes;
    }

    const DrawnHypercube& cube_;
    At zero_;
};

std::string cube_at(const DrawnHypercube& cube, At corner) {
    CubeArea area = area_of(cube.dimensions, cube.lines.size());
    std::string out = svg_text(corner + At{12, 24}, "caption", cube.title);
    out += CubeDrawing(cube, corner + area.zero).text();
    double y = area.height - text_line * static_cast<double>(cube.lines.size()) + 4;
    for (const std::string& line : cube.lines) {
        out += svg_text(corner + At{12, y}, "line", line);
        y += text_line;
    }
    return out;
}

std::string legend_at(const VertexLegend& legend, At at) {
    std::string out;
    for (const auto& [look, words] : legend) {
        out += vertex_symbol(at, look, "");
        out += svg_text(at + At{vertex_radius + 8, 4.5}, "line", words);
        at.x += vertex_radius * 2 + 36 + 6.6 * static_cast<double>(words.size());
    }
    return out;
}

double legend_width_of(const VertexLegend& legend) {
    double width = cube_margin;
    for (const auto& [look, words] : legend)
        width += vertex_radius * 2 + 36 + 6.6 * static_cast<double>(words.size());
    return width;
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
    std::string drawings;
    At corner{0, caption}, end{legend_width_of(legend), caption};
    double row_height = 0;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
        if (i > 0 && i % columns == 0)
            corner = {0, corner.y + std::exchange(row_height, 0)};
        CubeArea area = area_of(cubes[i].dimensions, cubes[i].lines.size());
        drawings += cube_at(cubes[i], corner);
        corner.x += area.width;
        row_height = std::max(row_height, area.height);
        end = {std::max(end.x, corner.x), corner.y + row_height};
    }
    double height = end.y + (legend.empty() ? 12 : legend_height + 12);
    std::string head =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
                    "<style>\n{2}</style>\n<defs><marker id=\"arrow\" viewBox=\"0 0 10 10\" refX=\"7\" refY=\"5\" "
                    "markerWidth=\"6\" markerHeight=\"6\" orient=\"auto-start-reverse\"><path d=\"M0 0 L10 5 L0 10 z\" "
                    "fill=\"#d55e00\"/></marker></defs>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                    svg_number(end.x), svg_number(height), hypercube_style);
    return head + svg_text({12, 27}, "title", title) + drawings + legend_at(legend, {30, end.y + legend_height / 2}) +
           "</svg>\n";
}

} // namespace placedpar
