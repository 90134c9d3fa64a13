#include "picture/svg_pen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace placedpar::picture {

std::string svg_number(double length) { return fmt::format("{}", std::round(length * 10) / 10 + 0.0); }

std::string svg_corners(const std::vector<Point>& corners) {
    std::string data;
    for (Point corner : corners)
        data += (data.empty() ? "M" : " L") + svg_point(corner);
    return data;
}

std::string SvgPen::title_of(std::string_view text) {
    std::string lines;
    for (std::size_t end = 0; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1))
        lines += as_markup(text.substr(0, end)) + "\n";
    lines += as_markup(text);
    return lines.empty() ? "" : "<title>" + lines + "</title>";
}

SvgPen& SvgPen::group(const SvgAttributes& attributes, const SvgPen& contents, std::string_view tooltip) {
    return element("g", attributes, {}, title_of(tooltip) + fmt::format("{}", fmt::join(contents.elements_, "")));
}

SvgPen& SvgPen::add(const SvgPen& other) {
    elements_.insert(elements_.end(), other.elements_.begin(), other.elements_.end());
    return *this;
}

SvgPen& SvgPen::element(const char* tag, const SvgAttributes& attributes, const SvgAttributes& more,
                        const std::string& contents) {
    std::string& out = elements_.emplace_back(std::string("<") + tag);
    for (const SvgAttributes* part : {&attributes, &more})
        for (const SvgAttribute& each : *part)
            if (!each.value.empty())
                out += fmt::format(" {}=\"{}\"", each.name, as_markup(each.value));
    out += contents.empty() ? "/>" : fmt::format(">{}</{}>", contents, tag);
    return *this;
}

std::string SvgPen::document(const Box& paper, const std::string& style, const std::string& arrow_heads,
                             const std::string& title) const {
    return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="{0} {1} {2} {3}" width="{2}" height="{3}">
{4}<style>
text {{ font-family: Helvetica, Arial, "DejaVu Sans", sans-serif; fill: #16202a; }}
{5}</style>
{6}<rect x="{0}" y="{1}" width="{2}" height="{3}" fill="#ffffff"/>
{7}
</svg>
)",
                       svg_number(paper.left()), svg_number(paper.top()), svg_number(paper.width),
                       svg_number(paper.height), title_of(title), style, arrow_heads, fmt::join(elements_, "\n"));
}

} // namespace placedpar::picture
