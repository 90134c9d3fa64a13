#include "picture/plot.hpp"

#include "picture/curve_style.hpp"
#include "picture/cut_off.hpp"
#include "picture/gnuplot.hpp"
#include "picture/plot_over_dates.hpp"
#include "picture/plot_room.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

// Sizes are in pixels.
constexpr int plot_width = 960, title_height = 44, panel_height = 390, left_margin = 104, top_margin = 40,
              bottom_margin = 66;
enum class XAxes { numbers, dates };

constexpr int legend_sample = 70, legend_letter = 9; // for the widest font that a viewer may use

/// Replaces what XML forbids in a text although gnuplot writes it: "]]>", and the codes U+FFFE and U+FFFF.
std::string fit_for_xml(std::string text) {
    for (const auto& [forbidden, instead] : {std::pair("]]>", "]] >"), {"\xEF\xBF\xBE", "?"}, {"\xEF\xBF\xBF", "?"}})
        for (std::size_t at = 0; (at = text.find(forbidden)) != text.npos;)
            text.replace(at, 3, instead);
    return text;
}

/// Returns a gnuplot string in single quotes. Only the quote itself is special in such a string.
std::string quoted(std::string text) {
    text = fit_for_xml(std::move(text));
    std::ranges::replace(text, '\n', ' ');
    std::string out = "'";
    for (char character : escaped(text))
        out += character == '\'' ? "''" : std::string(1, character);
    return out + "'";
}

std::size_t letters(const std::string& utf8) {
    return static_cast<std::size_t>(
        std::ranges::count_if(utf8, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

bool has_bars(const Series& series) { return !series.intervals.empty() || !series.x_intervals.empty(); }

std::string legend_of(const Series& series, const Panel& panel) {
    return series.name.empty() ? "" : series.name + text_of(cut_offs(series, panel));
}

/// Returns the width of the legends, in pixels. It is equal for all panels, so that their axes are aligned.
int legend_width(const Plot& plot) {
    std::size_t longest = 0;
    for (const Panel& panel : plot.panels) {
        for (const Series& series : panel.series)
            longest = std::max(longest, letters(legend_of(series, panel)));
        for (const GuideLine& mark : panel.marks)
            longest = std::max(longest, letters(mark.name));
        for (const Band& band : panel.bands)
            longest = std::max(longest, letters(band.name));
    }
    return longest == 0 ? 30 : legend_sample + legend_letter * static_cast<int>(longest);
}

std::string title_of(const std::string& name) { return name.empty() ? "notitle" : "title " + quoted(name); }

std::string range_commands(const char* letter, const Axis& axis) {
    auto end = [](std::optional<double> value) { return value ? fmt::format("{}", *value) : std::string("*"); };
    return fmt::format("{3} logscale {0}\nset {0}range [{1}:{2}]\n", letter, end(axis.from), end(axis.to),
                       axis.logarithmic ? "set" : "unset");
}

/// Returns the usual size of letters. If the text would then be longer than `length` pixels, returns a smaller size.
double letter_size(const std::string& text, double usual, int length) {
    return std::min(usual, 15. * length / (legend_letter * static_cast<double>(letters(text)) + 1));
}

/// Sets the label of an axis. The letters are smaller if the label would otherwise be longer than the axis.
std::string label_commands(const char* letter, const Axis& axis, int length) {
    double size = letter_size(axis.label, 15, length);
    return fmt::format("set {}label {} {}{}\n", letter, quoted(axis.label), *letter == 'x' ? "offset 0,0.4" : "",
                       size < 15 ? fmt::format(" font ',{:.1f}'", size) : "");
}

std::string data_block(const Panel& panel, std::size_t number, std::size_t place) {
    std::string out = fmt::format("$panel{}series{} << END\n", number, place);
    for (const Point& point : panel.series[place].points)
        out += fmt::format("{} {}\n", point.x, point.y);
    return out + "END\n";
}

/// Returns the data of bars: the start of each bar, and its length in x and y.
std::string bar_block(const Panel& panel, std::size_t number, std::size_t place) {
    const Series& series = panel.series[place];
    std::string out = fmt::format("$panel{}bars{} << END\n", number, place);
    for (std::size_t i = 0; i < series.intervals.size(); ++i)
        if (auto [low, high] = series.intervals[i]; std::isfinite(high - low))
            out += fmt::format("{} {} 0 {}\n", series.points[i].x, low, high - low);
    for (std::size_t i = 0; i < series.x_intervals.size(); ++i)
        if (auto [low, high] = series.x_intervals[i]; std::isfinite(high - low))
            out += fmt::format("{} {} {} 0\n", low, series.points[i].y, high - low);
    return out + "END\n";
}

std::string data_blocks(const Panel& panel, std::size_t number) {
    std::string out;
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        out += data_block(panel, number, i) + (has_bars(panel.series[i]) ? bar_block(panel, number, i) : "");
    for (std::size_t i = 0; i < panel.bands.size(); ++i) {
        out += fmt::format("$panel{}band{} << END\n", number, i);
        for (const BandPoint& point : panel.bands[i].points)
            out += fmt::format("{} {} {}\n", point.x, point.low, point.high);
        out += "END\n";
    }
    return out;
}

/// Returns commands that set the gnuplot variable Left to the left margin of all panels. A narrow range far from 0 has
/// long numbers at its axis, such as 1.0005e-09, and needs more than the usual margin. REQUIRES: trial_commands() have
/// drawn all panels.
std::string left_margin_commands(const Plot& plot) {
    constexpr int usual_letters = 5;
    std::string out = fmt::format("Letters = {}\n", usual_letters);
    for (std::size_t i = 0; i < plot.panels.size(); ++i)
        if (!plot.panels[i].y.logarithmic)
            for (const char* end : {"from", "to"})
                out += fmt::format("step = 10**floor(log10((Yto{0}-Yfrom{0})/10)); "
                                   "text = sprintf('%g', step*floor(Y{1}{0}/step+.5))\n"
                                   "Letters = strlen(text) > Letters ? strlen(text) : Letters\n",
                                   i, end);
    return out +
           fmt::format("Left = ({}+(Letters-{})*{})/{}.\n", left_margin, usual_letters, legend_letter, plot_width);
}

/// Returns the commands that place the panel. Gnuplot's screen has its origin at the bottom left, and its width and
/// height are 1.
std::string place_commands(std::size_t number, int legend, int height) {
    int top = title_height + static_cast<int>(number) * panel_height;
    auto from_bottom = [&](int pixels) { return static_cast<double>(height - pixels) / height; };
    double right = static_cast<double>(plot_width - legend) / plot_width;
    return fmt::format("set lmargin at screen Left\nset rmargin at screen {}\nset tmargin at screen {}\n"
                       "set bmargin at screen {}\nset key at screen {}, screen {} left top Left reverse "
                       "samplen 2 spacing 1.25\n",
                       right, from_bottom(top + top_margin), from_bottom(top + panel_height - bottom_margin),
                       right + 0.01, from_bottom(top + top_margin - 4));
}

/// Returns a gnuplot position at the distance `inside` from the edge, in panel widths or heights.
std::string near_edge(PanelEdge edge, double place, double inside) {
    switch (edge) {
    case PanelEdge::top: return fmt::format("first {}, graph {}", place, 1 - inside);
    case PanelEdge::bottom: return fmt::format("first {}, graph {}", place, inside);
    case PanelEdge::left: return fmt::format("graph {}, first {}", inside, place);
    case PanelEdge::right: return fmt::format("graph {}, first {}", 1 - inside, place);
    }
    return "";
}

/// Draws arrows where a series is cut off. If the series is not in the legend, its farthest value is written beside the
/// arrow.
std::string cut_commands(const Panel& panel, std::size_t place) {
    std::string out;
    for (const CutOff& cut : cut_offs(panel.series[place], panel)) {
        const bool upright = cut.edge == PanelEdge::top || cut.edge == PanelEdge::bottom;
        for (double at : cut.places)
            out += fmt::format("set arrow from {} to {} front filled size screen 0.012,18 fixed linewidth 2 linecolor "
                               "rgb '{}'\n",
                               near_edge(cut.edge, at, upright ? 0.08 : 0.035), near_edge(cut.edge, at, 0),
                               colour_of(panel, place));
        if (panel.series[place].name.empty() && !cut.places.empty())
            out += fmt::format("set label {} at {} center front font ',12' textcolor rgb '{}'\n",
                               quoted(text_of(std::vector{cut}).substr(1)),
                               near_edge(cut.edge, cut.places.front(), upright ? 0.13 : 0.08), colour_of(panel, place));
    }
    return out;
}

/// Draws bars as arrows with caps instead of heads.
std::string bars_of(const Panel& panel, std::size_t number, std::size_t place) {
    return fmt::format("$panel{}bars{} using {}:2:3:4 notitle with vectors heads size screen 0.004,90 fixed nofilled "
                       "linewidth 2 linecolor rgb '{}'",
                       number, place, column_of_x(panel, number, place), colour_of(panel, place));
}

std::string plot_command(const Panel& panel, std::size_t number) {
    std::vector<std::string> curves;
    for (std::size_t i = 0; i < panel.bands.size(); ++i)
        curves.push_back(fmt::format("$panel{}band{} using 1:2:3 {} {}", number, i, title_of(panel.bands[i].name),
                                     style_of(panel.bands[i])));
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        if (has_bars(panel.series[i]))
            curves.push_back(bars_of(panel, number, i));
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        curves.push_back(fmt::format("$panel{}series{} using {}:2 {} {}", number, i, column_of_x(panel, number, i),
                                     title_of(legend_of(panel.series[i], panel)), style_of(panel, i)));
    for (std::size_t i = 0; i < panel.marks.size(); ++i)
        curves.push_back(
            fmt::format("{} {} {}", panel.marks[i].y, title_of(panel.marks[i].name), style_of(panel.marks[i], i)));
    return fmt::format("plot {}\n", fmt::join(curves, ", \\\n     "));
}

/// Draws the panel without output, so that gnuplot chooses the ranges of the axes. In this trial, series with bars at
/// the same x are not yet shifted apart.
std::string trial_commands(const Panel& asked, std::size_t number) {
    const Panel panel = with_wide_axes(asked);
    return fmt::format("Xfrom{0} = 1; Xto{0} = 1\n", number) + data_blocks(panel, number) +
           range_commands("x", panel.x) + range_commands("y", panel.y) + plot_command(panel, number) +
           room_commands(panel, number);
}

/// Returns commands that label the axis with dates, which are a whole number of hours or days apart.
std::string date_commands(const Axis& axis) {
    constexpr double hour = 3600, day = 24 * hour, most = 7;
    constexpr std::array<double, 14> steps{hour,    2 * hour, 6 * hour, 12 * hour, day,       2 * day,   4 * day,
                                           7 * day, 14 * day, 28 * day, 91 * day,  182 * day, 365 * day, 3650 * day};
    const auto* found =
        std::ranges::find_if(steps, [&](double step) { return (*axis.to - *axis.from) / step <= most; });
    const double step = found == steps.end() ? (*axis.to - *axis.from) / most : *found;
    std::vector<std::string> places;
    for (double at = std::ceil(*axis.from / step) * step; at <= *axis.to; at += step)
        places.push_back(fmt::format("{:.0f}", at));
    return fmt::format("set format x '{}' timedate\nset xtics ({})\n", step < day ? "%d %b %H:%M" : "%Y-%m-%d",
                       fmt::join(places, ", "));
}

std::string panel_commands(const Panel& panel, std::size_t number, XAxes x_axes) {
    std::string out = "set title " + quoted(panel.title) + " offset 0,-0.4\nunset arrow\nunset label\n";
    out += label_commands("x", panel.x, plot_width - left_margin) +
           label_commands("y", panel.y, panel_height - top_margin - bottom_margin);
    if (x_axes == XAxes::dates)
        out += date_commands(panel.x);
    out += range_commands("x", panel.x) + range_commands("y", panel.y);
    out += fmt::format("set xrange [Xfrom{0}:Xto{0}]\nset yrange [Yfrom{0}:Yto{0}]\n", number);
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        out += cut_commands(panel, i);
    return out + plot_command(panel, number);
}

void check(const Plot& plot) {
    for (const Panel& panel : plot.panels) {
        if (panel.series.empty())
            throw std::invalid_argument(fmt::format("the panel \"{}\" has nothing to draw", panel.title));
        for (const Series& series : panel.series)
            if (series.points.empty())
                throw std::invalid_argument(
                    fmt::format("in the panel \"{}\" the series \"{}\" has no points", panel.title, series.name));
        for (const Series& series : panel.series)
            for (const auto* intervals : {&series.intervals, &series.x_intervals})
                if (!intervals->empty() && intervals->size() != series.points.size())
                    throw std::invalid_argument(
                        fmt::format("in the panel \"{}\" the series \"{}\" has {} points and {} intervals", panel.title,
                                    series.name, series.points.size(), intervals->size()));
        for (const Band& band : panel.bands)
            if (band.points.empty())
                throw std::invalid_argument(
                    fmt::format("in the panel \"{}\" the band \"{}\" has no points", panel.title, band.name));
    }
}

std::string script_of(const Plot& plot, XAxes x_axes) {
    int height = title_height + panel_height * static_cast<int>(plot.panels.size());
    std::string out = "set encoding utf8\nset samples 2\nset terminal unknown\n";
    for (std::size_t i = 0; i < plot.panels.size(); ++i)
        out += trial_commands(plot.panels[i], i);
    out += left_margin_commands(plot);
    out +=
        fmt::format("set terminal svg noenhanced size {},{} font 'Helvetica,Arial,sans-serif,15' background '#ffffff'\n"
                    "set border linecolor rgb '#404040'\nset grid linecolor rgb '#d8d8d8' linetype 1 linewidth 0.7\n"
                    "set tics nomirror\nset multiplot title {} font ',{:g}'\n",
                    plot_width, height, quoted(plot.title), letter_size(plot.title, 18, plot_width));
    int legend = legend_width(plot);
    for (std::size_t i = 0; i < plot.panels.size(); ++i)
        out += place_commands(i, legend, height) + panel_commands(plot.panels[i], i, x_axes);
    return out + "unset multiplot\n";
}

} // namespace

std::string draw_svg(const Plot& plot) {
    check(plot);
    return run_gnuplot(script_of(plot, XAxes::numbers));
}

std::string draw_svg_over_dates(const Plot& plot) {
    check(plot);
    return run_gnuplot(script_of(plot, XAxes::dates));
}

} // namespace placedpar
