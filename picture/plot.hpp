#pragma once

#include "text/interval.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

struct Point {
    double x, y;
};

enum class Stroke {
    line,   ///< of the dashes that belong to its colour, unless dashes mean something in its panel
    dashes, ///< of their own, where they mean something
    points,
    plain ///< a line without symbols or dashes, such as stairs
};

/// Texts are plain: "in³/s", not "in^3/s".
struct Series {
    std::string name; ///< in the legend; empty: not there
    std::vector<Point> points = {};
    Stroke stroke = Stroke::line;
    std::optional<int> colour = std::nullopt; ///< which of the eight; none: that of its place among the panel's series
    /// Of y, and of x, at each point: bars with caps. None: empty; none at a point: not a number. Series that have
    /// intervals of y at the same x are drawn a little beside each other.
    std::vector<Interval> intervals = {}, x_intervals = {};
};

/// The series through the points that point_at(0), ..., point_at(steps) give.
template <class PointAt>
Series curve(Series series, int steps, PointAt point_at) {
    for (int i = 0; i <= steps; ++i)
        series.points.push_back(point_at(i));
    return series;
}

struct BandPoint {
    double x, low, high;
};

/// The space between two curves, pale, behind all series.
struct Band {
    std::string name; ///< in the legend; empty: not there
    std::vector<BandPoint> points;
    int colour; ///< which of the eight
};

/// A horizontal line over the whole width, grey, of other dashes than the panel's other marks.
struct Mark {
    std::string name;
    double y;
    std::optional<int> colour = std::nullopt; ///< which of the eight, where it belongs to a series
};

struct Axis {
    std::string label = {}; ///< with unit: "pressure [psi]"
    std::optional<double> from = std::nullopt, to = std::nullopt;
    bool logarithmic = false;
};

/// One diagram. Its legend stands to the right of it. An axis goes farther than it is told where a series would touch
/// the frame there; a series that an axis cuts off has an arrow there instead, and says how far it goes: in the legend,
/// or where it has no name beside the arrow.
struct Panel {
    std::string title = {};
    Axis x = {}, y = {};
    std::vector<Series> series = {};
    std::vector<Mark> marks = {};
    std::vector<Band> bands = {};
};

/// Panels, one below the other.
struct Plot {
    std::string title;
    std::vector<Panel> panels;
};

/// A plot and the name of its file, without .svg.
struct NamedPlot {
    std::string name;
    Plot plot;
};

/// Drawn by gnuplot: the same plot gives the same bytes. Throws std::invalid_argument for a panel without series, a
/// series or a band without points and a series with intervals at some points only, UserError when gnuplot is not
/// there, std::runtime_error when it refuses the plot.
std::string draw_svg(const Plot&);

/// The points of its curves, intervals and bands as comma-separated values, a point a row, with the labels of its axes,
/// which have the units. All points, also those beyond the axes, and where they are, not a little beside.
std::string curves_csv(const Plot&);

} // namespace placedpar
