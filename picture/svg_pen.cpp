#include "picture/svg_pen.hpp"

#include "text/utf8.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace placedpar::picture {

namespace {

std::string text_of(const SvgAttributes& attributes) {
    std::string out;
    for (const auto& [name, value] : attributes)
        if (!value.empty())
            out += fmt::format(" {}=\"{}\"", name, as_markup(value));
    return out;
}

/// What is shown while the mouse rests on an element; it may have several lines.
std::string title_of(std::string_view text) {
    if (text.empty())
        return "";
    std::string out = "<title>";
    for (std::size_t end = 0; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1))
        out += as_markup(text.substr(0, end)) + "\n";
    return out + as_markup(text) + "</title>";
}

} // namespace

std::string svg_number(double length) { return fmt::format("{}", std::round(length * 10) / 10 + 0.0); }

std::string svg_corners(const std::vector<Point>& corners) {
    std::string data;
    for (Point corner : corners)
        data += (data.empty() ? "M" : " L") + svg_point(corner);
    return data;
}

SvgPen& SvgPen::path(const std::string& data, const SvgAttributes& attributes, std::string_view tooltip) {
    std::string start = fmt::format("<path{} d=\"{}\"", text_of(attributes), data);
    elements_.push_back(start + (tooltip.empty() ? "/>" : ">" + title_of(tooltip) + "</path>"));
    return *this;
}

SvgPen& SvgPen::text(Point at, const std::string& style_class, std::string_view text) {
    elements_.push_back(fmt::format("<text{} x=\"{}\" y=\"{}\">{}</text>", text_of({{"class", style_class}}),
                                    svg_number(at.x), svg_number(at.y), as_markup(text)));
    return *this;
}

SvgPen& SvgPen::group(const SvgAttributes& attributes, const SvgPen& contents, std::string_view tooltip) {
    elements_.push_back(
        fmt::format("<g{}>{}{}</g>", text_of(attributes), title_of(tooltip), fmt::join(contents.elements_, "")));
    return *this;
}

SvgPen& SvgPen::add(const SvgPen& other) {
    elements_.insert(elements_.end(), other.elements_.begin(), other.elements_.end());
    return *this;
}

SvgPen& SvgPen::shape(const char* tag, std::initializer_list<std::pair<const char*, double>> lengths,
                      const SvgAttributes& attributes) {
    SvgAttributes all;
    for (auto [name, length] : lengths)
        all.emplace_back(name, svg_number(length));
    all.insert(all.end(), attributes.begin(), attributes.end());
    elements_.push_back(fmt::format("<{}{}/>", tag, text_of(all)));
    return *this;
}

std::string SvgPen::document(const Box& paper, const std::string& style, const std::string& definitions,
                             const std::string& title) const {
    SvgPen all;
    all.rect(paper, {{"fill", "#ffffff"}}).add(*this);
    return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="{0} {1} {2} {3}" width="{2}" height="{3}">
{4}<style>
text {{ font-family: Helvetica, Arial, "DejaVu Sans", sans-serif; fill: #16202a; }}
{5}</style>
{6}{7}
</svg>
)",
                       svg_number(paper.left()), svg_number(paper.top()), svg_number(paper.width),
                       svg_number(paper.height), title_of(title), style, definitions, fmt::join(all.elements_, "\n"));
}

} // namespace placedpar::picture
