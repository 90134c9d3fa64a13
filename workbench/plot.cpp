#include "workbench/plot.hpp"

#include "workbench/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

namespace placedpar {

namespace {

/// Okabe and Ito's colours, distinguishable to the colour-blind too, the dark ones first; their yellow is replaced by
/// black, being hard to see on white.
constexpr std::array<const char*, 8> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                             "#E69F00", "#56B4E9", "#000000", "#7F7F7F"};

// Sizes in pixels.
constexpr int plot_width = 960, title_height = 44, panel_height = 390, left_margin = 104, top_margin = 40,
              bottom_margin = 66;
constexpr int legend_sample = 70, legend_letter = 9; // of the widest of the fonts that a viewer may take

/// A gnuplot string, in which nothing but the quote means anything.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (char character : text)
        out += character == '\'' ? "''" : std::string(1, character == '\n' ? ' ' : character);
    return out + "'";
}

std::size_t letters(const std::string& utf8) {
    return static_cast<std::size_t>(
        std::ranges::count_if(utf8, [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

/// Of the legends, the same for all panels so that their axes stand above each other.
int legend_width(const Plot& plot) {
    std::size_t longest = 0;
    for (const Panel& panel : plot.panels) {
        for (const Series& series : panel.series)
            longest = std::max(longest, letters(series.name));
        for (const Mark& mark : panel.marks)
            longest = std::max(longest, letters(mark.name));
        for (const Band& band : panel.bands)
            longest = std::max(longest, letters(band.name));
    }
    return longest == 0 ? 30 : legend_sample + legend_letter * static_cast<int>(longest);
}

std::string style_of(const Series& series, std::size_t place) {
    std::size_t colour = series.colour ? static_cast<std::size_t>(*series.colour) : place;
    std::string paint = fmt::format("linecolor rgb '{}'", colours[colour % colours.size()]);
    switch (series.stroke) {
    case Stroke::line: return "with lines linewidth 2 " + paint;
    case Stroke::dashes: return "with lines linewidth 2 dashtype (8,5) " + paint;
    case Stroke::points: return "with points pointtype 7 pointsize 0.65 " + paint;
    }
    return "";
}

/// Marks of a panel differ in their dashes.
std::string style_of(const Mark& mark, std::size_t place) {
    constexpr std::array<const char*, 3> dashes{"(4,4)", "(14,5)", "(14,5,3,5)"};
    return fmt::format("with lines linewidth 1.3 dashtype {} linecolor rgb '{}'", dashes[place % dashes.size()],
                       mark.colour ? colours[static_cast<std::size_t>(*mark.colour) % colours.size()] : "#606060");
}

std::string style_of(const Band& band) {
    return fmt::format("with filledcurves fillstyle transparent solid 0.2 noborder linecolor rgb '{}'",
                       colours[static_cast<std::size_t>(band.colour) % colours.size()]);
}

std::string title_of(const std::string& name) { return name.empty() ? "notitle" : "title " + quoted(name); }

std::string axis_commands(const char* letter, const Axis& axis) {
    auto end = [](std::optional<double> value) { return value ? fmt::format("{}", *value) : std::string("*"); };
    return fmt::format("set {0}label {1} {5}\n{4} logscale {0}\nset {0}range [{2}:{3}]\n", letter, quoted(axis.label),
                       end(axis.from), end(axis.to), axis.logarithmic ? "set" : "unset",
                       *letter == 'x' ? "offset 0,0.4" : "");
}

std::string data_blocks(const Panel& panel, std::size_t number) {
    std::string out;
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
        out += fmt::format("$panel{}series{} << END\n", number, i);
        for (const Point& point : panel.series[i].points)
            out += fmt::format("{} {}\n", point.x, point.y);
        out += "END\n";
    }
    for (std::size_t i = 0; i < panel.bands.size(); ++i) {
        out += fmt::format("$panel{}band{} << END\n", number, i);
        for (const BandPoint& point : panel.bands[i].points)
            out += fmt::format("{} {} {}\n", point.x, point.low, point.high);
        out += "END\n";
    }
    return out;
}

/// Where the panel stands: gnuplot's screen has its origin at the bottom left and size 1.
std::string place_commands(std::size_t number, int legend, int height) {
    int top = title_height + static_cast<int>(number) * panel_height;
    auto from_bottom = [&](int pixels) { return static_cast<double>(height - pixels) / height; };
    double right = static_cast<double>(plot_width - legend) / plot_width;
    return fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\n"
                       "set bmargin at screen {}\nset key at screen {}, screen {} left top Left reverse "
                       "samplen 2 spacing 1.25\n",
                       static_cast<double>(left_margin) / plot_width, right, from_bottom(top + top_margin),
                       from_bottom(top + panel_height - bottom_margin), right + 0.01,
                       from_bottom(top + top_margin - 4));
}

std::string panel_commands(const Panel& panel, std::size_t number) {
    std::string out = "set title " + quoted(panel.title) + " offset 0,-0.4\n";
    out += axis_commands("x", panel.x) + axis_commands("y", panel.y) + data_blocks(panel, number);
    std::vector<std::string> curves;
    for (std::size_t i = 0; i < panel.bands.size(); ++i)
        curves.push_back(fmt::format("$panel{}band{} using 1:2:3 {} {}", number, i, title_of(panel.bands[i].name),
                                     style_of(panel.bands[i])));
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        curves.push_back(fmt::format("$panel{}series{} using 1:2 {} {}", number, i, title_of(panel.series[i].name),
                                     style_of(panel.series[i], i)));
    for (std::size_t i = 0; i < panel.marks.size(); ++i)
        curves.push_back(
            fmt::format("{} {} {}", panel.marks[i].y, title_of(panel.marks[i].name), style_of(panel.marks[i], i)));
    return fmt::format("{}plot {}\n", out, fmt::join(curves, ", \\\n     "));
}

void check(const Plot& plot) {
    for (const Panel& panel : plot.panels) {
        if (panel.series.empty())
            throw std::invalid_argument(fmt::format("the panel \"{}\" has nothing to draw", panel.title));
        for (const Series& series : panel.series)
            if (series.points.empty())
                throw std::invalid_argument(
                    fmt::format("in the panel \"{}\" the series \"{}\" has no points", panel.title, series.name));
        for (const Band& band : panel.bands)
            if (band.points.empty())
                throw std::invalid_argument(
                    fmt::format("in the panel \"{}\" the band \"{}\" has no points", panel.title, band.name));
    }
}

std::string script_of(const Plot& plot) {
    int height = title_height + panel_height * static_cast<int>(plot.panels.size());
    std::string out =
        fmt::format("set encoding utf8\n"
                    "set terminal svg noenhanced size {},{} font 'Helvetica,Arial,sans-serif,15' background '#ffffff'\n"
                    "set border linecolor rgb '#404040'\nset grid linecolor rgb '#d8d8d8' linetype 1 linewidth 0.7\n"
                    "set samples 2\nset tics nomirror\nset multiplot title {} font ',18'\n",
                    plot_width, height, quoted(plot.title));
    int legend = legend_width(plot);
    for (std::size_t i = 0; i < plot.panels.size(); ++i)
        out += place_commands(i, legend, height) + panel_commands(plot.panels[i], i);
    return out + "unset multiplot\n";
}

} // namespace

std::string draw_svg(const Plot& plot) {
    check(plot);
    return run_gnuplot(script_of(plot));
}

} // namespace placedpar
