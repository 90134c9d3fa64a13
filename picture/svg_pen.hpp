#pragma once

#include "picture/geometry.hpp"
#include "text/utf8.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace placedpar::picture {

/// Prints a length, rounded to a tenth of a pixel.
std::string svg_number(double length);
inline std::string svg_point(Point p) { return svg_number(p.x) + " " + svg_number(p.y); }
/// Returns the path data of straight lines through all corners.
std::string svg_corners(const std::vector<Point>& corners);

/// An attribute of an element. It is written only if it has a value.
struct SvgAttribute {
    SvgAttribute(const char* given, std::string text) : name(given), value(std::move(text)) {}
    SvgAttribute(const char* given, double length) : name(given), value(svg_number(length)) {}
    const char* name;
    std::string value;
};
using SvgAttributes = std::vector<SvgAttribute>;

/// Writes SVG elements in the order of painting. Each element is written on its own line, a group with its elements on
/// one line. The pen escapes special characters in texts and values.
class SvgPen {
public:
    SvgPen& rect(const Box& b, const SvgAttributes& more = {}) {
        return element("rect", {{"x", b.left()}, {"y", b.top()}, {"width", b.width}, {"height", b.height}}, more);
    }
    SvgPen& ellipse(Point at, double rx, double ry, const SvgAttributes& more = {}) {
        return element("ellipse", {{"cx", at.x}, {"cy", at.y}, {"rx", rx}, {"ry", ry}}, more);
    }
    SvgPen& circle(Point at, double radius, const SvgAttributes& more = {}) {
        return element("circle", {{"cx", at.x}, {"cy", at.y}, {"r", radius}}, more);
    }
    SvgPen& line(Point from, Point to, const SvgAttributes& more = {}) {
        return element("line", {{"x1", from.x}, {"y1", from.y}, {"x2", to.x}, {"y2", to.y}}, more);
    }
    SvgPen& path(const std::string& data, const SvgAttributes& attributes = {}, std::string_view tooltip = "") {
        return element("path", attributes, {{"d", data}}, title_of(tooltip));
    }
    SvgPen& text(Point at, const std::string& style_class, std::string_view text) {
        return element("text", {{"class", style_class}}, {{"x", at.x}, {"y", at.y}}, as_markup(text));
    }
    SvgPen& group(const SvgAttributes&, const SvgPen& contents, std::string_view tooltip = "");
    SvgPen& add(const SvgPen& other);

    /// Returns an SVG document with everything that was drawn, on white paper. `arrow_heads`: SVG definitions of the
    /// markers at the ends of paths.
    std::string document(const Box& paper, const std::string& style, const std::string& arrow_heads = "",
                         const std::string& title = "") const;

private:
    /// Returns the element for a tooltip. The text may have several lines.
    static std::string title_of(std::string_view text);
    SvgPen& element(const char* tag, const SvgAttributes&, const SvgAttributes& more, const std::string& contents = "");

    std::vector<std::string> elements_;
};

} // namespace placedpar::picture
