#pragma once

#include "picture/geometry.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// Names and values; an attribute without a value is not written.
using SvgAttributes = std::vector<std::pair<const char*, std::string>>;

/// A length to a tenth of a pixel.
std::string svg_number(double length);
inline std::string svg_point(Point p) { return svg_number(p.x) + " " + svg_number(p.y); }
/// The data of a path that leads straight from corner to corner.
std::string svg_corners(const std::vector<Point>& corners);

/// This class writes SVG: elements in the order in which they are painted, each on a line of its own, those of a group
/// on one. It escapes texts and values.
class SvgPen {
public:
    SvgPen& rect(const Box& box, const SvgAttributes& attributes = {}) {
        return shape("rect", {{"x", box.left()}, {"y", box.top()}, {"width", box.width}, {"height", box.height}},
                     attributes);
    }
    SvgPen& ellipse(const Box& box, const SvgAttributes& attributes = {}) {
        return shape("ellipse",
                     {{"cx", box.centre.x}, {"cy", box.centre.y}, {"rx", box.width / 2}, {"ry", box.height / 2}},
                     attributes);
    }
    SvgPen& circle(Point centre, double radius, const SvgAttributes& attributes = {}) {
        return shape("circle", {{"cx", centre.x}, {"cy", centre.y}, {"r", radius}}, attributes);
    }
    SvgPen& line(Point from, Point to, const SvgAttributes& attributes = {}) {
        return shape("line", {{"x1", from.x}, {"y1", from.y}, {"x2", to.x}, {"y2", to.y}}, attributes);
    }
    SvgPen& path(const std::string& data, const SvgAttributes& attributes = {}, std::string_view tooltip = "");
    SvgPen& text(Point at, const std::string& style_class, std::string_view text);
    SvgPen& group(const SvgAttributes& attributes, const SvgPen& contents, std::string_view tooltip = "");
    /// Appends what another pen has drawn.
    SvgPen& add(const SvgPen& other);

    /// The file: all that was drawn, on white paper. `arrow_heads` are the markers at the ends of its paths.
    std::string document(const Box& paper, const std::string& style, const std::string& arrow_heads = "",
                         const std::string& title = "") const;

private:
    SvgPen& shape(const char* tag, std::initializer_list<std::pair<const char*, double>> lengths,
                  const SvgAttributes& attributes);

    std::vector<std::string> elements_;
};

} // namespace placedpar::picture
