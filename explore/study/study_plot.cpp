#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace placedpar {

namespace {

constexpr std::size_t most_curves = 8; ///< that have a colour of their own

std::set<std::string> values_of_axis(const StudySummary& summary, std::size_t axis) {
    std::set<std::string> values;
    for (const StudyLine& line : summary.lines)
        values.insert(line.values[axis]);
    return values;
}

/// How many different values, if all are numbers; 0 if not.
std::size_t count_numbers(const StudySummary& summary, std::size_t axis) {
    std::set<std::string> values = values_of_axis(summary, axis);
    bool numbers =
        std::ranges::all_of(values, [](const std::string& value) { return number_of_setting(value).has_value(); });
    return numbers ? values.size() : 0;
}

std::size_t axis_called(const StudySummary& summary, const std::string& name) {
    auto found = std::ranges::find(summary.axes, name);
    if (found == summary.axes.end())
        throw UserError(fmt::format("\"{}\" does not have several values in this study", name));
    auto axis = static_cast<std::size_t>(found - summary.axes.begin());
    if (count_numbers(summary, axis) == 0)
        throw UserError(fmt::format("\"{}\" has values that are no numbers, so nothing can be drawn over it", name));
    return axis;
}

std::size_t axis_to_draw_over(const StudySummary& summary, const std::string& name) {
    if (!name.empty())
        return axis_called(summary, name);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < summary.axes.size(); ++i)
        if (count_numbers(summary, i) > (best ? count_numbers(summary, *best) : 0))
            best = i;
    if (!best)
        throw UserError("nothing that this study sets has several values that are numbers, so there is no plot");
    return *best;
}

/// What differs between curves of the other axes, on a line: the name of its curve.
std::string curve_of(const StudySummary& summary, const StudyLine& line, std::size_t over) {
    std::string name;
    for (std::size_t i = 0; i < summary.axes.size(); ++i)
        if (i != over && values_of_axis(summary, i).size() > 1)
            name += fmt::format("{}{} = {}", name.empty() ? "" : ", ", summary.axes[i],
                                line.values[i].empty() ? "-" : line.values[i]);
    return name;
}

/// Over more than a decade or two what is multiplied, not added, is compared: where half of the values crowd in a
/// quarter of the axis.
bool is_drawn_by_decades(const StudySummary& summary, std::size_t over) {
    constexpr double wide = 30, crowded = .25;
    std::set<double> values;
    for (const StudyLine& line : summary.lines)
        values.insert(*number_of_setting(line.values[over]));
    const double least = *values.begin(), greatest = *values.rbegin();
    const double median = *std::next(values.begin(), static_cast<std::ptrdiff_t>((values.size() - 1) / 2));
    return least > 0 && greatest / least > wide && median < crowded * greatest;
}

/// A range with room beside what is drawn in it, so that no point lies on the frame.
struct RoomyRange {
    double least = std::numeric_limits<double>::max(), most = std::numeric_limits<double>::lowest();
    bool logarithmic = false;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    /// A value moved by a part of the range.
    double moved(double value, double part) const {
        return logarithmic ? value * std::pow(most / least, part) : value + part * (most - least);
    }
    void give_to(Axis& axis) const {
        constexpr double room = .05;
        bool wide = least < most;
        double margin = least == 0 ? 1 : std::abs(least) / 2;
        axis.from = wide ? moved(least, -room) : least - margin;
        axis.to = wide ? moved(most, room) : most + margin;
        if (least > 0 && !logarithmic)
            axis.from = std::max(*axis.from, 0.);
    }
};

/// The curves of one measure, by name in the order of the lines. Those that have intervals stand a little beside each
/// other, so that one interval does not hide another.
class PanelOfMeasure {
public:
    PanelOfMeasure(const StudySummary& summary, std::size_t measure, std::size_t over)
        : summary_(summary), measure_(measure), over_(over) {
        x_.logarithmic = is_drawn_by_decades(summary, over);
        for (const StudyLine& line : summary.lines)
            add(line);
        set_beside();
    }

    Panel panel() && {
        curves_.insert(curves_.end(), bars_.begin(), bars_.end());
        Panel panel{.x = {.label = summary_.axes[over_], .logarithmic = x_.logarithmic},
                    .y = {.label = measure_with_unit(summary_, measure_)},
                    .series = std::move(curves_)};
        if (!panel.series.empty()) {
            x_.give_to(panel.x);
            y_.give_to(panel.y);
        }
        return panel;
    }

private:
    void add(const StudyLine& line) {
        if (line.cells[measure_].runs == 0)
            return;
        std::size_t curve = number_of(curve_of(summary_, line, over_));
        const StudyCell& cell = line.cells[measure_];
        double x = *number_of_setting(line.values[over_]);
        curves_[curve].points.push_back({x, cell.mean});
        x_.add(x);
        y_.add(cell.mean - std::max(cell.half_width, 0.));
        y_.add(cell.mean + std::max(cell.half_width, 0.));
        if (cell.half_width > 0)
            bars_.push_back({.name = "",
                             .points = {{x, cell.mean - cell.half_width}, {x, cell.mean + cell.half_width}},
                             .stroke = Stroke::bar,
                             .colour = static_cast<int>(curve)});
    }

    void set_beside() {
        if (bars_.empty())
            return;
        auto beside = [&](double x, int curve) {
            return x_.moved(x, .008 * (curve - static_cast<double>(curves_.size() - 1) / 2));
        };
        for (Series& curve : curves_)
            for (Point& point : curve.points)
                point.x = beside(point.x, *curve.colour);
        for (Series& bar : bars_)
            bar.points = with_caps(beside(bar.points[0].x, *bar.colour), bar.points[0].y, bar.points[1].y);
    }

    std::vector<Point> with_caps(double x, double low, double high) const {
        double left = x_.moved(x, -.005), right = x_.moved(x, .005);
        return {{left, low}, {right, low}, {x, low}, {x, high}, {left, high}, {right, high}};
    }

    std::size_t number_of(const std::string& curve) {
        auto [found, is_new] = numbers_.emplace(curve, curves_.size());
        if (is_new && curves_.size() == most_curves)
            throw UserError(fmt::format("more than {} curves cannot be told apart: draw over another axis with --over, "
                                        "or sweep less",
                                        most_curves));
        if (is_new)
            curves_.push_back({.name = curve, .colour = static_cast<int>(found->second)});
        return found->second;
    }

    const StudySummary& summary_;
    std::size_t measure_, over_;
    RoomyRange x_, y_;
    std::map<std::string, std::size_t> numbers_;
    std::vector<Series> curves_, bars_;
};

} // namespace

Plot summary_plot(const StudySummary& summary, const std::string& over) {
    std::size_t axis = axis_to_draw_over(summary, over);
    Plot plot{.title = summary.netlist, .panels = {}};
    for (std::size_t i = 0; i < summary.measures.size(); ++i)
        if (Panel panel = PanelOfMeasure(summary, i, axis).panel(); !panel.series.empty())
            plot.panels.push_back(std::move(panel));
    if (plot.panels.empty())
        throw UserError("no run has what was to be measured, so there is nothing to draw");
    return plot;
}

} // namespace placedpar
