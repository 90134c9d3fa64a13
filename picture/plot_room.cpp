#include "picture/plot_room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace placedpar {

namespace {

// These lengths are fractions of an axis's length.
constexpr double near_frame = .025, room_at_frame = .05, step_beside = .008;

/// Selects one axis: its letter, and the members of a panel that belong to it.
struct AxisParts {
    char letter;
    Axis Panel::*axis;
    double Point::*coordinate;
    std::vector<Interval> Series::*intervals;
};
constexpr AxisParts along_x{'X', &Panel::x, &Point::x, &Series::x_intervals},
    along_y{'Y', &Panel::y, &Point::y, &Series::intervals};

/// The range of the values of a panel's series along one axis.
class Extent {
public:
    Extent(const Panel& panel, const AxisParts& parts) : axis_(panel.*parts.axis) {
        for (const Series& series : panel.series) {
            for (const Point& point : series.points)
                add(point.*parts.coordinate);
            for (const Interval& interval : series.*parts.intervals) {
                add(interval.low);
                add(interval.high);
            }
        }
    }

    /// Extends the range by the panel's bands and marks.
    void add_bands_and_marks(const Panel& panel, const AxisParts& parts) {
        for (const Band& band : panel.bands)
            for (const BandPoint& point : band.points)
                for (double value :
                     parts.letter == 'X' ? std::array{point.x, point.x} : std::array{point.low, point.high})
                    add(value);
        if (parts.letter == 'Y')
            for (const GuideLine& mark : panel.marks)
                add(mark.y);
    }

    double least() const { return least_; }
    double most() const { return most_; }
    bool is_cut_below() const { return axis_.from && least_ < *axis_.from - seen(); }
    bool is_cut_above() const { return axis_.to && most_ > *axis_.to + seen(); }

private:
    void add(double value) {
        if (!std::isfinite(value) || (axis_.logarithmic && value <= 0))
            return;
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }
    double seen() const { return 1e-6 * (most_ - least_); }

    const Axis& axis_;
    double least_ = std::numeric_limits<double>::max(), most_ = std::numeric_limits<double>::lowest();
};

/// Returns gnuplot's expression for `place`, shifted by the fraction `part` of the axis from `from` to `to`.
std::string moved_along(const Axis& axis, const std::string& place, double part, const std::string& from,
                        const std::string& to) {
    return axis.logarithmic ? fmt::format("{}*({}/{})**({:g})", place, to, from, part)
                            : fmt::format("{}+({}-{})*({:g})", place, to, from, part);
}

bool have_intervals_at_one_x(const Series& one, const Series& other) {
    return !one.intervals.empty() && !other.intervals.empty() &&
           std::ranges::any_of(
               one.points,
               [&](double x) { return std::ranges::find(other.points, x, &Point::x) != other.points.end(); },
               &Point::x);
}

/// Returns the indices of the series that must be shifted apart, in order.
std::vector<std::size_t> drawn_beside(const Panel& panel) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        for (std::size_t other = 0; other < panel.series.size(); ++other)
            if (other != i && have_intervals_at_one_x(panel.series[i], panel.series[other])) {
                places.push_back(i);
                break;
            }
    return places;
}

double part_beside(std::size_t place, std::size_t places) {
    return step_beside * (static_cast<double>(place) - static_cast<double>(places - 1) / 2);
}

std::string room_commands(const Panel& panel, std::size_t number, const AxisParts& parts, double near) {
    const Axis& axis = panel.*parts.axis;
    const Extent extent(panel, parts);
    return fmt::format("a = GPVAL_{0}_MIN; b = GPVAL_{0}_MAX\n"
                       "{0}from{1} = {2:d} && {3} < {4} ? {5} : a\n"
                       "{0}to{1} = {6:d} && {7} > {8} ? {9} : b\n",
                       parts.letter, number, !extent.is_cut_below(), extent.least(),
                       moved_along(axis, "a", near, "a", "b"), moved_along(axis, "a", -room_at_frame, "a", "b"),
                       !extent.is_cut_above(), extent.most(), moved_along(axis, "b", -near, "a", "b"),
                       moved_along(axis, "b", room_at_frame, "a", "b"));
}

void widen_axis(Panel& panel, const AxisParts& parts) {
    Extent extent(panel, parts);
    extent.add_bands_and_marks(panel, parts);
    Axis& axis = panel.*parts.axis;
    if (axis.from || axis.to || extent.least() != extent.most())
        return;
    const double margin = extent.least() == 0 ? 1 : std::abs(extent.least()) / 2;
    axis.from = extent.least() - margin;
    axis.to = extent.most() + margin;
}

} // namespace

std::string room_commands(const Panel& panel, std::size_t number) {
    const std::size_t places = drawn_beside(panel).size();
    const double farthest = places == 0 ? 0 : part_beside(places - 1, places);
    return room_commands(panel, number, along_x, near_frame + farthest) +
           room_commands(panel, number, along_y, near_frame);
}

Panel with_wide_axes(Panel panel) {
    widen_axis(panel, along_x);
    widen_axis(panel, along_y);
    return panel;
}

std::string column_of_x(const Panel& panel, std::size_t number, std::size_t place) {
    const std::vector<std::size_t> places = drawn_beside(panel);
    const auto found = std::ranges::find(places, place);
    if (found == places.end())
        return "1";
    const auto number_among = static_cast<std::size_t>(found - places.begin());
    return "(" +
           moved_along(panel.x, "$1", part_beside(number_among, places.size()), fmt::format("Xfrom{}", number),
                       fmt::format("Xto{}", number)) +
           ")";
}

} // namespace placedpar
