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
    line,   ///< a line with the dashes of its colour; solid if some colour of the panel has both a `line` and `dashes`
    dashes, ///< dashes that distinguish the series from a `line` of the same colour
    points,
    plain ///< a line without symbols or dashes, for example a step curve
};

/// A curve or a set of points of a diagram. Texts are plain, without markup: "in³/s" instead of "in^3/s".
struct Series {
    std::string name; ///< name in the legend; if empty, the series is not in the legend
    std::vector<Point> points = {};
    Stroke stroke = Stroke::line;
    std::optional<int> colour = std::nullopt; ///< one of the eight colours; nullopt: the default colour for the index
                                              ///< of the series in the panel
    /// Intervals of y, and of x, at each point, drawn as bars with caps. An empty list means no intervals; NaN means no
    /// interval at this point. If several series have intervals of y at the same x, the series are shifted sideways a
    /// little, so that the bars do not overlap.
    std::vector<Interval> intervals = {}, x_intervals = {};
};

/// Returns the series with the points point_at(0), ..., point_at(steps).
template <class PointAt>
Series curve(Series series, int steps, PointAt point_at) {
    for (int i = 0; i <= steps; ++i)
        series.points.push_back(point_at(i));
    return series;
}

struct BandPoint {
    double x, low, high;
};

/// The space between two curves, drawn in a pale colour behind all series.
struct Band {
    std::string name; ///< name in the legend; if empty, the band is not in the legend
    std::vector<BandPoint> points;
    int colour; ///< one of the eight colours
};

/// A horizontal line over the whole width, grey unless it has a colour. Neighbouring lines of a panel have different
/// dashes.
struct GuideLine {
    std::string name;
    double y;
    std::optional<int> colour = std::nullopt; ///< one of the eight colours, if the line belongs to a series
};

struct Axis {
    std::string label = {}; ///< label with unit, such as "pressure [psi]"
    std::optional<double> from = std::nullopt, to = std::nullopt;
    bool logarithmic = false;
};

/// A diagram with its legend to the right. If a series would touch the frame at the end of an axis, the axis is
/// extended a little. If an axis cuts off a series, an arrow marks the place at the frame. The farthest value is in the
/// legend or, if the series has no name, beside the arrow.
struct Panel {
    std::string title = {};
    Axis x = {}, y = {};
    std::vector<Series> series = {};
    std::vector<GuideLine> marks = {};
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

/// Draws the plot by gnuplot; the same plot gives the same bytes. Throws std::invalid_argument for a panel without
/// series, for a series or a band without points, and for a series with intervals at only some of its points. Throws
/// UserError if gnuplot is not installed or refuses the plot.
std::string draw_svg(const Plot&);

/// Prints the points of the plot's curves, intervals and bands as comma-separated values. There is a row for each
/// point, with the labels of the axes, which contain the units. Points beyond the ends of the axes are included. Each
/// point has its exact x.
std::string curves_csv(const Plot&);

} // namespace placedpar
