#include "picture/curve_style.hpp"

#include "picture/gnuplot.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <set>
#include <stdexcept>
#include <string>

using namespace placedpar;

namespace {

Panel panel_of(std::initializer_list<Stroke> strokes) {
    Panel panel;
    for (Stroke stroke : strokes)
        panel.series.push_back({"", {{0, 0}, {1, 1}}, stroke});
    return panel;
}

bool says(const std::string& style, const std::string& word) { return style.find(word) != style.npos; }

} // namespace

TEST_CASE("the ninth series has the first of eight colours again") {
    std::set<std::string> colours;
    for (int number = 0; number < 8; ++number)
        colours.insert(colour_named(number));
    CHECK(colours.size() == 8);
    CHECK(std::string(colour_named(8)) == colour_named(0));
}

TEST_CASE("a series has the colour of its index, or its own") {
    Panel panel = panel_of({Stroke::line, Stroke::line});
    CHECK(std::string(colour_of(panel, 1)) == colour_named(1));
    panel.series[1].colour = 5;
    CHECK(std::string(colour_of(panel, 1)) == colour_named(5));
    CHECK(says(style_of(panel, 1), colour_named(5)));
}

TEST_CASE("several curves differ in dashes and symbols; a single curve has neither") {
    CHECK(style_of(panel_of({Stroke::line}), 0).starts_with("with lines "));
    const Panel several = panel_of({Stroke::line, Stroke::line, Stroke::line});
    std::set<std::string> styles;
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(style_of(several, i).starts_with("with linespoints "));
        const std::string style = style_of(several, i);
        styles.insert(style.substr(0, style.find("linecolor")));
    }
    CHECK(styles.size() == 3);
}

TEST_CASE("points have no line, steps no symbols, and dashes distinguish curves of one colour") {
    CHECK(style_of(panel_of({Stroke::points, Stroke::line}), 0).starts_with("with points "));
    CHECK(style_of(panel_of({Stroke::plain, Stroke::line}), 0).starts_with("with lines linewidth 2 linecolor"));
    Panel pair = panel_of({Stroke::line, Stroke::dashes});
    pair.series[1].colour = 0;
    CHECK(says(style_of(pair, 0), "dashtype solid"));
    CHECK(says(style_of(pair, 1), "dashtype (8,5)"));
}

TEST_CASE("three marks differ in their dashes, and are grey unless they have a colour") {
    std::set<std::string> styles;
    for (std::size_t place = 0; place < 3; ++place)
        styles.insert(style_of(GuideLine{"", 1}, place));
    CHECK(styles.size() == 3);
    CHECK(says(style_of(GuideLine{"", 1}, 0), "#606060"));
    CHECK(says(style_of(GuideLine{"", 1, 2}, 0), colour_named(2)));
    CHECK(says(style_of(Band{"", {}, 2}), colour_named(2)));
}

TEST_CASE("a gnuplot error is reported with gnuplot's message") {
    CHECK(run_gnuplot("set terminal dumb; plot x").find('*') != std::string::npos);
    CHECK_THROWS_WITH_AS(run_gnuplot("plot"), doctest::Contains("function to plot expected"), std::runtime_error);
    CHECK_NOTHROW(require_gnuplot());
}

TEST_CASE("the message about a missing gnuplot names it") {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    CHECK_THROWS_WITH_AS(require_gnuplot(), doctest::Contains("gnuplot"), UserError);
    CHECK_THROWS_WITH_AS(run_gnuplot("plot x"), doctest::Contains("gnuplot"), UserError);
    ::setenv("PATH", path.c_str(), 1);
}
