#include "picture/curve_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar {

namespace {

/// The colours of Okabe and Ito, which the colour-blind can distinguish, in order from dark to light. Black replaces
/// their yellow, which is hard to see on white.
constexpr std::array<const char*, 8> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                             "#E69F00", "#56B4E9", "#000000", "#7F7F7F"};

/// Gnuplot's numbers of the symbols, one for each colour: a circle, a square, triangles, a rhombus, and outlines.
constexpr std::array<int, colours.size()> symbols{7, 5, 9, 13, 11, 6, 4, 8};
/// The approximate number of symbols on a curve.
constexpr std::size_t symbols_of_curve = 9;

/// The dashes for each colour: lengths of strokes and gaps.
constexpr std::array<const char*, colours.size()> dashes{"solid",     "(9,4)",          "(2,3)", "(14,4,3,4)",
                                                         "(5,2,5,7)", "(14,4,3,4,3,4)", "(3,7)", "(6,3,2,3)"};
constexpr const char* asked_for = "(8,5)"; // pattern of Stroke::dashes

std::size_t colour_number(const Panel& panel, std::size_t place) {
    const auto& asked = panel.series[place].colour;
    return (asked ? static_cast<std::size_t>(*asked) : place) % colours.size();
}

/// Returns whether a series of the panel has this stroke and this colour.
bool has_series(const Panel& panel, Stroke stroke, std::size_t number) {
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        if (panel.series[i].stroke == stroke && colour_number(panel, i) == number)
            return true;
    return false;
}

/// Returns whether some colour is used both for a line and for a dashed line.
bool dashes_have_a_meaning(const Panel& panel) {
    for (std::size_t number = 0; number < colours.size(); ++number)
        if (has_series(panel, Stroke::line, number) && has_series(panel, Stroke::dashes, number))
            return true;
    return false;
}

/// Returns whether the curve needs no symbols. A curve with intervals needs symbols. Another curve needs none in three
/// cases: it is the only series, the panel has points of its colour, or it is dashed and dashes have no meaning.
bool needs_no_symbols(const Panel& panel, std::size_t place) {
    const std::size_t number = colour_number(panel, place);
    if (!panel.series[place].intervals.empty())
        return false;
    return panel.series.size() == 1 || has_series(panel, Stroke::points, number) ||
           (panel.series[place].stroke == Stroke::dashes && !dashes_have_a_meaning(panel));
}

/// Returns whether lines of this colour are solid: no line has another colour, or dashes have a meaning.
bool needs_no_dashes(const Panel& panel, std::size_t number) {
    bool alone = true;
    for (std::size_t other = 0; other < colours.size(); ++other)
        alone = alone && (other == number || !has_series(panel, Stroke::line, other));
    return alone || dashes_have_a_meaning(panel);
}

std::string dashes_of(const Panel& panel, std::size_t place) {
    const std::size_t number = colour_number(panel, place);
    if (panel.series[place].stroke == Stroke::dashes)
        return asked_for;
    return needs_no_dashes(panel, number) ? "solid" : dashes[number];
}

std::string curve_style(const Panel& panel, std::size_t place) {
    const std::size_t number = colour_number(panel, place);
    const std::string look =
        fmt::format("linewidth 2 dashtype {} linecolor rgb '{}'", dashes_of(panel, place), colours[number]);
    if (needs_no_symbols(panel, place))
        return "with lines " + look;
    const std::size_t every = std::max<std::size_t>(panel.series[place].points.size() / symbols_of_curve, 1);
    return fmt::format("with linespoints pointtype {} pointsize 0.7 pointinterval {} {}", symbols[number], every, look);
}

} // namespace

const char* colour_named(int number) { return colours[static_cast<std::size_t>(number) % colours.size()]; }

const char* colour_of(const Panel& panel, std::size_t place) { return colours[colour_number(panel, place)]; }

std::string style_of(const Panel& panel, std::size_t place) {
    switch (panel.series[place].stroke) {
    case Stroke::line:
    case Stroke::dashes: return curve_style(panel, place);
    case Stroke::plain: return fmt::format("with lines linewidth 2 linecolor rgb '{}'", colour_of(panel, place));
    case Stroke::points:
        return fmt::format("with points pointtype {} pointsize 0.65 linecolor rgb '{}'",
                           symbols[colour_number(panel, place)], colour_of(panel, place));
    }
    return "";
}

std::string style_of(const GuideLine& mark, std::size_t place) {
    constexpr std::array<const char*, 3> dashes_of_marks{"(4,4)", "(14,5)", "(14,5,3,5)"};
    return fmt::format("with lines linewidth 1.3 dashtype {} linecolor rgb '{}'",
                       dashes_of_marks[place % dashes_of_marks.size()],
                       mark.colour ? colour_named(*mark.colour) : "#606060");
}

std::string style_of(const Band& band) {
    return fmt::format("with filledcurves fillstyle transparent solid 0.2 noborder linecolor rgb '{}'",
                       colour_named(band.colour));
}

} // namespace placedpar
