#include "picture/cut_off.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace placedpar {

namespace {

constexpr double seen = 1e-6; ///< smallest visible part of an axis's length; anything smaller counts as rounding

/// Converts values to positions along an axis as it is drawn: 0 and 1 are the given ends of the axis.
class Scale {
public:
    explicit Scale(const Axis& axis)
        : logarithmic_(axis.logarithmic), from_(shown(axis.from.value_or(axis.logarithmic ? 1 : 0))),
          length_(axis.from && axis.to ? shown(*axis.to) - from_ : 1) {}

    double place(double value) const { return (shown(value) - from_) / length_; }
    double value(double place) const {
        const double at = from_ + place * length_;
        return logarithmic_ ? std::exp(at) : at;
    }

private:
    double shown(double value) const { return logarithmic_ ? std::log(value) : value; }

    bool logarithmic_;
    double from_, length_;
};

/// An end of an axis, which is an edge of the panel at which series may be cut off. `axis_` is perpendicular to this
/// edge, `along_` parallel to it.
class End {
public:
    End(PanelEdge edge, const Panel& panel)
        : vertical_(edge == PanelEdge::top || edge == PanelEdge::bottom),
          upper_(edge == PanelEdge::top || edge == PanelEdge::right), axis_(vertical_ ? panel.y : panel.x),
          along_(vertical_ ? panel.x : panel.y), scale_(axis_), along_scale_(along_) {}

    bool is_given() const { return at().has_value(); }
    double value(const Point& point) const { return vertical_ ? point.y : point.x; }
    double along(const Point& point) const { return vertical_ ? point.x : point.y; }
    double farther(double one, double other) const { return upper_ ? std::max(one, other) : std::min(one, other); }

    /// Returns whether the end cuts the point off. Points beyond the ends of the other axis do not count.
    bool cuts(const Point& point) const { return beyond(value(point)) && is_along(along(point)); }
    bool is_along(double place) const {
        const double shown = along_scale_.place(place);
        return !(along_.from && shown < along_scale_.place(*along_.from) - seen) &&
               !(along_.to && shown > along_scale_.place(*along_.to) + seen);
    }
    /// Returns whether the point is on the visible side of this end.
    bool is_inside(const Point& point) const { return std::isfinite(value(point)) && !beyond(value(point)); }
    /// Returns the position along the edge at which the drawn line between the two points crosses the edge.
    double crossing(const Point& inside, const Point& outside) const {
        const double from = scale_.place(value(inside)), to = scale_.place(value(outside));
        const double share = (scale_.place(*at()) - from) / (to - from);
        const double place = std::lerp(along_scale_.place(along(inside)), along_scale_.place(along(outside)), share);
        return std::isfinite(place) ? along_scale_.value(place) : along(inside);
    }

private:
    std::optional<double> at() const { return upper_ ? axis_.to : axis_.from; }
    bool beyond(double value) const {
        const double over = scale_.place(value) - scale_.place(*at());
        return upper_ ? over > seen : over < -seen;
    }

    bool vertical_, upper_;
    const Axis &axis_, &along_;
    Scale scale_, along_scale_;
};

/// Returns the position along the edge at which the series leaves or enters the panel. The points [first, last) are all
/// beyond the end.
double place_of(const End& end, const Series& series, std::size_t first, std::size_t last) {
    const auto& points = series.points;
    const bool line = series.stroke != Stroke::points;
    if (line && first > 0 && end.is_inside(points[first - 1]))
        return end.crossing(points[first - 1], points[first]);
    if (line && last < points.size() && end.is_inside(points[last]))
        return end.crossing(points[last], points[last - 1]);
    return end.along(points[first]);
}

/// Returns the points of a series, followed by the end points of its bars.
std::vector<Point> with_ends_of_bars(const Series& series) {
    std::vector<Point> points = series.points;
    for (std::size_t i = 0; i < series.intervals.size(); ++i)
        for (double y : {series.intervals[i].low, series.intervals[i].high})
            points.push_back({series.points[i].x, y});
    for (std::size_t i = 0; i < series.x_intervals.size(); ++i)
        for (double x : {series.x_intervals[i].low, series.x_intervals[i].high})
            points.push_back({x, series.points[i].y});
    return points;
}

/// Adds the positions at which bars extend beyond the end.
void add_places_of_bars(const End& end, const Series& series, std::vector<double>& places) {
    const std::vector<Point> all = with_ends_of_bars(series);
    for (std::size_t i = series.points.size(); i < all.size(); ++i)
        if (end.cuts(all[i]) && end.is_along(end.along(all[i])) &&
            std::ranges::find(places, end.along(all[i])) == places.end())
            places.push_back(end.along(all[i]));
}

std::vector<double> places_of(const End& end, const Series& series) {
    std::vector<double> places;
    auto cut = [&](const Point& point) { return end.cuts(point); };
    for (auto first = std::ranges::find_if(series.points, cut); first != series.points.end();) {
        auto last = std::find_if_not(first, series.points.end(), cut);
        const double place = place_of(end, series, static_cast<std::size_t>(first - series.points.begin()),
                                      static_cast<std::size_t>(last - series.points.begin()));
        if (end.is_along(place))
            places.push_back(place);
        first = std::find_if(last, series.points.end(), cut);
    }
    add_places_of_bars(end, series, places);
    return places;
}

std::optional<double> farthest_of(const End& end, const Series& series) {
    std::optional<double> farthest;
    for (const Point& point : with_ends_of_bars(series))
        if (end.cuts(point))
            farthest = end.farther(end.value(point), farthest.value_or(end.value(point)));
    return farthest;
}

constexpr std::array edges{PanelEdge::top, PanelEdge::bottom, PanelEdge::left, PanelEdge::right};
constexpr std::array<const char*, edges.size()> arrows{"\u2191", "\u2193", "\u2190", "\u2192"};

} // namespace

std::vector<CutOff> cut_offs(const Series& series, const Panel& panel) {
    std::vector<CutOff> found;
    for (PanelEdge edge : edges)
        if (const End end(edge, panel); end.is_given())
            if (auto farthest = farthest_of(end, series))
                found.push_back({edge, *farthest, places_of(end, series)});
    return found;
}

std::string text_of(const std::vector<CutOff>& cut_offs) {
    std::string text;
    for (const CutOff& cut_off : cut_offs)
        text += fmt::format(" {} to {:.3g}", arrows[static_cast<std::size_t>(cut_off.edge)], cut_off.farthest);
    return text;
}

} // namespace placedpar
