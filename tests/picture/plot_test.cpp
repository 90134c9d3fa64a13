#include "picture/plot.hpp"

#include "picture/cut_off.hpp"
#include "picture/plot_room.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

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

/// Returns the different dash patterns.
std::set<std::string> dashes_in(const std::string& svg) {
    const std::string attribute = "stroke-dasharray='";
    std::set<std::string> found;
    for (std::size_t at = svg.find(attribute); at != std::string::npos; at = svg.find(attribute, at + 1)) {
        const std::size_t from = at + attribute.size();
        found.insert(svg.substr(from, svg.find('\'', from) - from));
    }
    return found;
}

/// A bar of an interval, in pixels.
struct DrawnBar {
    double x, top, bottom;
};

/// Returns the upright bars with a cap at each end, from left to right. REQUIRES: all bars of the plot have caps.
std::vector<DrawnBar> bars_in(const std::string& svg) {
    const std::string place = R"(([\d.]+),([\d.]+))", line = "M" + place + R"(\s+L)" + place, turn = R"(\s+L)" + place;
    const std::regex bar(line + turn + R"(\s+)" + line + turn + R"(\s+)" + line);
    std::vector<DrawnBar> bars;
    for (std::sregex_iterator each(svg.begin(), svg.end(), bar), end; each != end; ++each) {
        auto at = [&](std::size_t group) { return std::stod((*each)[group]); };
        const bool upright = at(13) == at(15) && at(1) < at(3) && at(3) < at(5) && at(2) == at(4) && at(4) == at(6);
        if (upright)
            bars.push_back({at(13), std::min(at(14), at(16)), std::max(at(14), at(16))});
    }
    std::ranges::sort(bars, {}, &DrawnBar::x);
    return bars;
}

/// Returns the places of symbols, in pixels, from left to right.
std::vector<double> symbols_in(const std::string& svg) {
    const std::regex symbol(R"(xlink:href='#gpPt\d+' transform='translate\(([\d.]+),)");
    std::vector<double> places;
    for (std::sregex_iterator each(svg.begin(), svg.end(), symbol), end; each != end; ++each)
        places.push_back(std::stod((*each)[1]));
    std::ranges::sort(places);
    return places;
}

/// A curve of `steps` steps from corner to corner of its panel.
Series long_curve(int steps) {
    return curve({.name = ""}, steps, [&](int i) { return Point{1. * i, 1. * i}; });
}

/// Returns the distance in pixels between the frame and the nearest symbol, in a plot of one panel without a legend.
double nearest_to_frame(const std::string& svg) {
    const double left = 104, right = 930, top = 84, bottom = 368;
    double nearest = std::numeric_limits<double>::max();
    const std::regex symbol(R"(xlink:href='#gpPt\d+' transform='translate\(([\d.]+),([\d.]+)\))");
    for (std::sregex_iterator each(svg.begin(), svg.end(), symbol), end; each != end; ++each) {
        const double x = std::stod((*each)[1]), y = std::stod((*each)[2]);
        nearest = std::min({nearest, x - left, right - x, y - top, bottom - y});
    }
    return nearest;
}

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

TEST_CASE("equal plots give equal bytes, different plots different bytes") {
    Plot plot = small_plot();
    CHECK(draw_svg(plot) == draw_svg(plot));
    Plot other = plot;
    other.panels[0].series[0].points[1].y = 1.7;
    CHECK(draw_svg(plot) != draw_svg(other));
}

TEST_CASE("texts are escaped for gnuplot and XML") {
    Plot plot = small_plot();
    plot.panels[0].series[0].name = "it's a_b^2 <\\n & {/Bold @x} \"q\" `date`";
    std::string svg = draw_svg(plot);
    CHECK(has(svg, ">it's a_b^2 &lt;\\n &amp; {/Bold @x} \"q\" `date`<"));
}

TEST_CASE("series have distinct colours unless they choose the same") {
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

TEST_CASE("marks have distinct dashes and their chosen colour") {
    Plot plot = small_plot();
    plot.panels[0].marks = {{"one", 1.2}, {"two", 1.4}, {"three", 1.6}};
    std::string svg = draw_svg(plot);
    CHECK(count(svg, "stroke-dasharray") > 0);
    CHECK(dashes_in(svg).size() == 3);
    CHECK_FALSE(has(svg, "213,  94,   0"));
    plot.panels[0].marks[1].colour = 1;
    CHECK(has(draw_svg(plot), "213,  94,   0"));
}

TEST_CASE("a band is drawn pale in its chosen colour, with its name") {
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

TEST_CASE("a plot that cannot be drawn is refused") {
    Plot plot = small_plot();
    plot.panels[0].series[0].points.clear();
    CHECK_THROWS_WITH_AS(draw_svg(plot), "in the panel \"panel\" the series \"line\" has no points",
                         std::invalid_argument);
    plot.panels[0].series.clear();
    CHECK_THROWS_AS(draw_svg(plot), std::invalid_argument);

    plot = small_plot();
    plot.panels[0].x = {"x", 5, 5};
    for (int i = 0; i < 100000; ++i) // more than the buffer of a pipe
        plot.panels[0].series[0].points.push_back({1.0 * i, 1});
    CHECK_THROWS_WITH_AS(draw_svg(plot), doctest::Contains("empty x range"), std::runtime_error);
}

TEST_CASE("no point lies on the frame") {
    for (Axis axis : {Axis{}, Axis{.from = 20, .to = 100}, Axis{.from = 20}, Axis{.logarithmic = true},
                      Axis{.from = 20, .to = 100, .logarithmic = true}}) {
        Panel panel{"", axis, axis, {{"", {{20, 20}, {40, 30}, {100, 100}}, Stroke::points}}};
        CHECK(nearest_to_frame(draw_svg({"", {panel}})) > 5);
        for (const char* ends : {"first", "last"}) { // short curves have a symbol at each point
            panel.series = {{"", {{20, 20}, {100, 50}}}, {"", {{20, 100}, {50, ends[0] == 'f' ? 20. : 100.}}}};
            CHECK(nearest_to_frame(draw_svg({"", {panel}})) > 5);
        }
    }
    Panel beyond{"", {}, {.from = 0, .to = 10}, {{"", {{2, 3}, {3, 10}, {4, 12}}, Stroke::points}}};
    CHECK(nearest_to_frame(draw_svg({"", {beyond}})) < 1); // points that are cut off need no margin
}

TEST_CASE("symbols and curve ends keep a distance from the frame") {
    Series fallen = long_curve(600);
    for (Point& point : fallen.points)
        point.y = 600 - point.y;
    for (Axis axis : {Axis{}, Axis{.from = 0, .to = 600}, Axis{.from = -5, .to = 605}}) {
        Panel panel{"", axis, axis, {long_curve(600), fallen}};
        CHECK(nearest_to_frame(draw_svg({"", {panel}})) > 5);
        panel.series.pop_back(); // a single curve has no symbols, but its line still ends before the frame
        const std::string svg = draw_svg({"", {panel}});
        const std::regex line(R"(stroke='rgb\(  0, 114, 178\)'\s+d='M([\d.]+),([\d.]+))");
        std::smatch found;
        REQUIRE(std::regex_search(svg, found, line));
        CHECK(std::stod(found[1]) > 104 + 5);
        CHECK(std::stod(found[2]) < 368 - 5);
    }
}

TEST_CASE("an interval is drawn as a bar with caps, away from the frame, and its point as a symbol") {
    Plot plot{"", {{"", {}, {.from = 0, .to = 10}, {{.name = "", .points = {{0, 4}, {1, 6}}}}}}};
    plot.panels[0].series[0].intervals = {{0, 6}, {5, 10}};
    const std::string svg = draw_svg(plot);
    const std::vector<DrawnBar> bars = bars_in(svg);
    REQUIRE(bars.size() == 2);
    CHECK(symbols_in(svg) == std::vector{bars[0].x, bars[1].x});
    CHECK(bars[0].x > 104 + 5);
    CHECK(bars[0].bottom < 368 - 5);
    CHECK(bars[1].top > 84 + 5);
    CHECK((bars[0].bottom - bars[0].top) / (bars[1].bottom - bars[1].top) == doctest::Approx(6. / 5).epsilon(.001));

    plot.panels[0].series[0].intervals[0] = {std::numeric_limits<double>::quiet_NaN(), 6}; // unknown
    CHECK(bars_in(draw_svg(plot)).size() == 1);
    plot.panels[0].series[0].intervals.pop_back();
    CHECK_THROWS_WITH_AS(draw_svg(plot), "in the panel \"\" the series \"\" has 2 points and 1 intervals",
                         std::invalid_argument);
}

TEST_CASE("bars of several curves at one x stand side by side; a single bar is not shifted") {
    for (bool logarithmic : {false, true}) {
        Series series{.name = "", .points = {{10, 4}}, .stroke = Stroke::points, .intervals = {{3, 5}}};
        Panel panel{"", {.from = 1, .to = 100, .logarithmic = logarithmic}, {}, {series, series, series}};
        const std::string svg = draw_svg({"", {panel}});
        const std::vector<DrawnBar> bars = bars_in(svg);
        REQUIRE(bars.size() == 3);
        CHECK(bars[1].x - bars[0].x > 4);
        CHECK(bars[2].x - bars[1].x == doctest::Approx(bars[1].x - bars[0].x).epsilon(.01));
        CHECK(symbols_in(svg) == std::vector{bars[0].x, bars[1].x, bars[2].x});

        panel.series = {series};
        const std::vector<DrawnBar> alone = bars_in(draw_svg({"", {panel}}));
        REQUIRE(alone.size() == 1);
        CHECK(alone[0].x == doctest::Approx(bars[1].x));

        panel.series = {series, series};
        panel.series[1].points[0].x = 50;
        const std::vector<DrawnBar> apart = bars_in(draw_svg({"", {panel}}));
        REQUIRE(apart.size() == 2);
        CHECK(apart[0].x == doctest::Approx(alone[0].x));
    }
}

TEST_CASE("points of a single value lie in the middle of the axis") {
    Plot plot{"", {{"", {}, {}, {{"", {{40, 7}}, Stroke::points}}}}};
    const std::string svg = draw_svg(plot);
    CHECK(symbols_in(svg) == std::vector{517.});
    CHECK(has(svg, "> 20<"));
    CHECK(has(svg, "> 60<"));
}

TEST_CASE("a dashed limit has no symbols") {
    Plot plot = small_plot();
    const Series line = plot.panels[0].series[0];
    plot.panels[0].series = {line, line, {.name = "limit", .points = {{1, 1}, {1, 2}}, .stroke = Stroke::dashes}};
    CHECK(count(draw_svg(plot), "#gpPt8") == 0);
}

TEST_CASE("a label longer than its axis has smaller letters") {
    Plot plot = small_plot();
    CHECK(count(draw_svg(plot), "font-size=\"15.00\"  text-anchor=\"middle\"") > 0);
    plot.panels[0].y.label = "relative island[0].generations_per_second";
    const std::string svg = draw_svg(plot);
    const std::size_t text = svg.find(plot.panels[0].y.label), group = svg.rfind("<g ", text);
    CHECK(has(svg.substr(group, text - group), "font-size=\"11.5"));
    CHECK(has(svg.substr(group, text - group), "rotate(270)"));
}

TEST_CASE("the label of the y axis stands left of wide numbers, inside the picture") {
    auto base_of_label = [](double from, double to) { // in pixels from the left; letters are 11 pixels high
        Plot plot = small_plot();
        plot.panels.resize(1);
        plot.panels[0].marks.clear();
        plot.panels[0].bands.clear();
        plot.panels[0].y = {.label = "compliance [m3/Pa]"};
        plot.panels[0].series = {{.name = "", .points = {{1, from}, {2, to}}}};
        const std::string svg = draw_svg(plot);
        const std::size_t text = svg.find("compliance"), place = svg.rfind("translate(", text);
        return std::stod(svg.substr(place + 10));
    };
    CHECK(base_of_label(1, 2) > 11);
    CHECK(base_of_label(1.0005e-9, 1.0011e-9) > 11);
    CHECK(base_of_label(-1.00051e-9, -1.00050e-9) > 11);
}

TEST_CASE("a title wider than the plot has smaller letters") {
    Plot plot = small_plot();
    CHECK(count(draw_svg(plot), "font-size=\"18.00\"") == 1);
    plot.title = "Figure 5.7: islands beside one genetic algorithm (experiment #5), medians of 240 seeds, all of them";
    CHECK(count(draw_svg(plot), "font-size=\"18.00\"") == 0);
}

TEST_CASE("an axis from 0 begins at 0 also below a logarithmic panel") {
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

TEST_CASE("several curves have distinct symbols to be readable in grey; a single curve has none") {
    Plot plot = small_plot();
    const std::size_t alone = count(draw_svg(plot), "#gpPt6");
    Series line = plot.panels[0].series[0];
    for (int i = 0; i < 100; ++i)
        line.points.push_back({2 + 0.1 * i, 1 + 0.01 * i});
    plot.panels[0].series = {line, line, line};
    const std::string svg = draw_svg(plot);
    for (const char* symbol : {"#gpPt6", "#gpPt4", "#gpPt8"}) // circle, square, triangle
        CHECK(count(svg, symbol) >= 8);
    CHECK(alone == 0);
}

TEST_CASE("the legend states how far a curve goes beyond the axis") {
    Plot plot = small_plot();
    plot.panels[0].series[0].points = {{0, 1}, {1, 7.5}, {2, -3}, {3, 99}};
    CHECK(has(draw_svg(plot), ">line<"));
    plot.panels[0].x.to = 2;
    CHECK(has(draw_svg(plot), ">line \u2192 to 3<"));
    plot.panels[0].y.to = 5; // 99 does not count, because it is beyond the end of the x axis
    CHECK(has(draw_svg(plot), ">line \u2191 to 7.5<"));
    plot.panels[0].y.from = 0;
    CHECK(has(draw_svg(plot), ">line \u2191 to 7.5 \u2193 to -3<"));
}

TEST_CASE("an arrow marks a cut-off curve, with its farthest value if the curve is not in the legend") {
    Plot plot = small_plot();
    Series& line = plot.panels[0].series[0];
    const std::string whole = draw_svg(plot);
    plot.panels[0].y.to = 1.7;
    const std::string cut = draw_svg(plot);
    CHECK(count(cut, "<path") + count(cut, "<polygon") > count(whole, "<path") + count(whole, "<polygon"));
    CHECK(has(cut, ">line \u2191 to 2<"));
    line.name.clear();
    CHECK(has(draw_svg(plot), "\u2191 to 2<"));
    plot.panels[0].y.to = 2;
    CHECK_FALSE(has(draw_svg(plot), "\u2191"));
}

TEST_CASE("several curves have distinct dashes; single curves, points and bars have none") {
    Plot plot = small_plot();
    CHECK(dashes_in(draw_svg(plot)).empty());
    const Series line = plot.panels[0].series[0];
    plot.panels[0].series.resize(8, line);
    CHECK(dashes_in(draw_svg(plot)).size() == 7); // the first is a solid line
    for (std::size_t i = 1; i < 8; ++i)
        plot.panels[0].series[i].stroke = i % 2 ? Stroke::points : Stroke::plain;
    CHECK(dashes_in(draw_svg(plot)).empty());
}

TEST_CASE("if dashes distinguish curves of one colour, they do not distinguish colours") {
    Plot plot = small_plot();
    const Series line = plot.panels[0].series[0];
    plot.panels[0].series = {line, line, line, line};
    for (std::size_t i = 0; i < 4; ++i) {
        plot.panels[0].series[i].colour = static_cast<int>(i / 2);
        plot.panels[0].series[i].stroke = i % 2 ? Stroke::dashes : Stroke::line;
    }
    CHECK(dashes_in(draw_svg(plot)).size() == 1);
}

TEST_CASE("curves are written as comma-separated values with every point and units") {
    Plot plot = small_plot();
    plot.panels[0].title = "a \"b\", c";
    plot.panels[0].bands = {{"band", {{0, 1, 2}}, 0}};
    CHECK(curves_csv(plot) == "panel,curve,x axis,x,y axis,y\n"
                              "\"a \"\"b\"\", c\",\"line\",\"x [s]\",0,\"y [psi]\",1\n"
                              "\"a \"\"b\"\", c\",\"line\",\"x [s]\",1,\"y [psi]\",2\n"
                              "\"a \"\"b\"\", c\",\"line\",\"x [s]\",2,\"y [psi]\",1.5\n"
                              "\"a \"\"b\"\", c\",\"band, lower end\",\"x [s]\",0,\"y [psi]\",1\n"
                              "\"a \"\"b\"\", c\",\"band, upper end\",\"x [s]\",0,\"y [psi]\",2\n");
    plot.panels[0] = {"p", {"x"}, {"y"}, {{.name = "line", .points = {{3, 4}}, .intervals = {{1, 5}}}}};
    plot.panels[0].series.push_back(plot.panels[0].series[0]);
    plot.panels[0].series[1].x_intervals = {{2, 4}};
    CHECK(has(curves_csv(plot), "\"p\",\"line\",\"x\",3,\"y\",4\n"
                                "\"p\",\"line, lower end\",\"x\",3,\"y\",1\n"
                                "\"p\",\"line, upper end\",\"x\",3,\"y\",5\n"
                                "\"p\",\"line, left end\",\"x\",2,\"y\",4\n"
                                "\"p\",\"line, right end\",\"x\",4,\"y\",4\n"));
}

TEST_CASE("bands and marks beside a constant curve are fully visible") {
    Panel panel{.series = {{"median", {{1, 4}, {2, 4}}}},
                .marks = {{"as it is", 9}},
                .bands = {{"", {{1, 0, 20}, {2, 0, 20}}, 0}}};
    CHECK_FALSE(with_wide_axes(panel).y.to); // gnuplot chooses the ends so that everything is visible
    panel.bands.clear();
    CHECK_FALSE(with_wide_axes(panel).y.to);
    panel.marks.clear();
    CHECK(with_wide_axes(panel).y.to == 6);
}

TEST_CASE("a cut-off bar has an arrow with its farthest value") {
    Panel panel{.y = {.from = 0, .to = 10}, .series = {{"rate", {{1, 4}, {2, 5}}, Stroke::points}}};
    panel.series[0].intervals = {{3, 5}, {4, 55}};
    const std::vector<CutOff> found = cut_offs(panel.series[0], panel);
    REQUIRE(found.size() == 1);
    CHECK(found[0].farthest == 55);
    CHECK(found[0].places == std::vector<double>{2});
}

TEST_CASE("a point without an interval has no bar in the data") {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Panel panel{.series = {{"rate", {{1, 4}, {2, 5}}, Stroke::points}}};
    panel.series[0].intervals = {{3, 5}, {none, none}};
    CHECK(curves_csv({"", {panel}}).find("nan") == std::string::npos);
}
