#include "workbench/plot.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

using namespace placedpar;

namespace {

Plot small_plot() {
    Panel panel{"panel", {"x [s]"}, {"y [psi]"}, {{"line", {{0, 1}, {1, 2}, {2, 1.5}}}}};
    return {"title", {panel}};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

bool has(const std::string& text, const std::string& part) { return count(text, part) > 0; }

} // namespace

TEST_CASE("a plot has its title, axes, panels, series and marks, each once") {
    Plot plot = small_plot();
    plot.panels.push_back({"second", {"x2 [s]"}, {"y2 [in³]"}, {{"points", {{3, 4}}, Stroke::points}}, {{"limit", 3}}});
    std::string svg = draw_svg(plot);
    for (const char* text :
         {"title", "panel", "x [s]", "y [psi]", "line", "second", "x2 [s]", "y2 [in³]", "points", "limit"})
        CHECK(count(svg, ">" + std::string(text) + "<") == 1);
    CHECK(has(svg, "</svg>"));
    CHECK(svg.size() > draw_svg(small_plot()).size());
}

TEST_CASE("the same plot gives the same bytes, another one others") {
    Plot plot = small_plot();
    CHECK(draw_svg(plot) == draw_svg(plot));
    Plot other = plot;
    other.panels[0].series[0].points[1].y = 1.7;
    CHECK(draw_svg(plot) != draw_svg(other));
}

TEST_CASE("texts mean nothing to gnuplot or XML") {
    Plot plot = small_plot();
    plot.panels[0].series[0].name = "it's a_b^2 <\\n & {/Bold @x} \"q\" `date`";
    std::string svg = draw_svg(plot);
    CHECK(has(svg, ">it's a_b^2 &lt;\\n &amp; {/Bold @x} \"q\" `date`<"));
}

TEST_CASE("series have distinct colours, unless they ask for the same one") {
    Plot plot = small_plot();
    Series line = plot.panels[0].series[0];
    for (int i = 1; i < 8; ++i)
        plot.panels[0].series.push_back(line);
    std::string svg = draw_svg(plot);
    for (const char* colour : {"0, 114, 178", "213,  94,   0", "  0, 158, 115", "204, 121, 167"})
        CHECK(has(svg, colour));
    plot.panels[0].series[1].colour = 0;
    CHECK(draw_svg(plot) != svg);
}

TEST_CASE("marks have distinct dashes, and the colour that they ask for") {
    Plot plot = small_plot();
    plot.panels[0].marks = {{"one", 1.2}, {"two", 1.4}, {"three", 1.6}};
    std::string svg = draw_svg(plot);
    CHECK(count(svg, "stroke-dasharray") > 0);
    std::set<std::string> dashes;
    for (std::size_t at = svg.find("stroke-dasharray"); at != std::string::npos;
         at = svg.find("stroke-dasharray", at + 1))
        dashes.insert(svg.substr(at, svg.find_first_of(";>", at) - at));
    CHECK(dashes.size() == 3);
    CHECK_FALSE(has(svg, "213,  94,   0"));
    plot.panels[0].marks[1].colour = 1;
    CHECK(has(draw_svg(plot), "213,  94,   0"));
}

TEST_CASE("a band is pale, in the colour it asks for, with its name") {
    Plot plot = small_plot();
    std::string without = draw_svg(plot);
    plot.panels[0].bands = {{"quartiles", {{0, 0.5, 1.5}, {2, 1, 2}}, 2}};
    std::string svg = draw_svg(plot);
    CHECK(count(svg, ">quartiles<") == 1);
    CHECK(count(svg, "fill-opacity") > count(without, "fill-opacity"));
    CHECK(has(svg, "0, 158, 115"));
    plot.panels[0].bands[0].points.clear();
    CHECK_THROWS_WITH_AS(draw_svg(plot), "in the panel \"panel\" the band \"quartiles\" has no points",
                         std::invalid_argument);
}

TEST_CASE("what cannot be drawn is refused") {
    Plot plot = small_plot();
    plot.panels[0].series[0].points.clear();
    CHECK_THROWS_WITH_AS(draw_svg(plot), "in the panel \"panel\" the series \"line\" has no points",
                         std::invalid_argument);
    plot.panels[0].series.clear();
    CHECK_THROWS_AS(draw_svg(plot), std::invalid_argument);

    plot = small_plot();
    plot.panels[0].x = {"x", 5, 5};
    for (int i = 0; i < 100000; ++i) // more than a pipe holds
        plot.panels[0].series[0].points.push_back({1.0 * i, 1});
    CHECK_THROWS_WITH_AS(draw_svg(plot), doctest::Contains("empty x range"), std::runtime_error);
}

TEST_CASE("an axis from 0 begins there below a logarithmic one too") {
    Plot plot = small_plot();
    plot.panels.push_back(plot.panels[0]);
    for (Panel& panel : plot.panels)
        panel.x = {"x", 1, 3};
    plot.panels[0].y = {"y", std::nullopt, std::nullopt, true};
    plot.panels[1].y = {"y", 0};
    plot.panels[1].series = {{"line", {{1, 8}, {3, 9}}}};
    CHECK(count(draw_svg(plot), "> 0<") == 1);
}

TEST_CASE("a gap in a series is a gap in its line") {
    Plot plot = small_plot();
    std::string whole = draw_svg(plot);
    plot.panels[0].series[0].points[1].y = std::numeric_limits<double>::quiet_NaN();
    CHECK(draw_svg(plot) != whole);
}
