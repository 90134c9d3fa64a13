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

constexpr std::size_t most_curves = 8; ///< number of curves with different colours

std::set<std::string> values_of_axis(const StudySummary& summary, std::size_t axis) {
    std::set<std::string> values;
    for (const StudyLine& line : summary.lines)
        values.insert(line.values[axis]);
    return values;
}

/// Returns the number of different values of the axis if all are numbers; otherwise 0.
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
        throw UserError(fmt::format("\"{}\" has values that are not numbers, so nothing can be drawn over it", name));
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
        throw UserError("no plot: no setting of this study has several values that are numbers");
    return *best;
}

/// Returns the name of the curve that contains this combination: its values on the other axes, except axes with a
/// single value.
std::string curve_of(const StudySummary& summary, const StudyLine& line, std::size_t over) {
    std::string name;
    for (std::size_t i = 0; i < summary.axes.size(); ++i)
        if (i != over && values_of_axis(summary, i).size() > 1)
            name += (name.empty() ? "" : ", ") + shown_setting(summary, line, i);
    return name;
}

/// Returns whether the axis is logarithmic: the values are positive, span a factor of more than 30, and half of them
/// would crowd in the first quarter of a linear axis.
bool is_drawn_by_decades(const StudySummary& summary, std::size_t over) {
    constexpr double wide = 30, crowded = .25;
    std::set<double> values;
    for (const StudyLine& line : summary.lines)
        values.insert(*number_of_setting(line.values[over]));
    const double least = *values.begin(), greatest = *values.rbegin();
    const double median = *std::next(values.begin(), static_cast<std::ptrdiff_t>((values.size() - 1) / 2));
    return least > 0 && greatest / least > wide && median < crowded * greatest;
}

/// The curves of one measure, in the order of the lines.
class PanelOfMeasure {
public:
    PanelOfMeasure(const StudySummary& summary, std::size_t measure, std::size_t over)
        : summary_(summary), measure_(measure), over_(over) {
        for (const StudyLine& line : summary.lines)
            add(line);
        for (Series& curve : curves_)
            if (std::ranges::all_of(curve.intervals, [](const Interval& each) { return std::isnan(each.low); }))
                curve.intervals.clear();
    }

    Panel panel() && {
        return {.x = {.label = summary_.axes[over_], .logarithmic = is_drawn_by_decades(summary_, over_)},
                .y = {.label = measure_with_unit(summary_, measure_)},
                .series = std::move(curves_)};
    }

private:
    void add(const StudyLine& line) {
        if (line.cells[measure_].runs == 0)
            return;
        std::size_t curve = number_of(curve_of(summary_, line, over_));
        const StudyCell& cell = line.cells[measure_];
        double x = *number_of_setting(line.values[over_]);
        curves_[curve].points.push_back({x, cell.mean});
        curves_[curve].intervals.push_back(interval_of(cell));
    }

    /// Returns the interval; NaN if all runs have the same value.
    static Interval interval_of(const StudyCell& cell) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const double half = cell.half_width > 0 ? cell.half_width : none;
        return {cell.mean - half, cell.mean + half};
    }

    std::size_t number_of(const std::string& curve) {
        auto [found, is_new] = numbers_.emplace(curve, curves_.size());
        if (is_new && curves_.size() == most_curves)
            throw UserError(fmt::format("the plot would have more than {} curves, too many to tell apart: choose "
                                        "another axis with --over, or sweep fewer values",
                                        most_curves));
        if (is_new)
            curves_.push_back({.name = curve, .colour = static_cast<int>(found->second)});
        return found->second;
    }

    const StudySummary& summary_;
    std::size_t measure_, over_;
    std::map<std::string, std::size_t> numbers_;
    std::vector<Series> curves_;
};

} // namespace

Plot summary_plot(const StudySummary& summary, const std::string& over) {
    std::size_t axis = axis_to_draw_over(summary, over);
    Plot plot{.title = summary.netlist, .panels = {}};
    for (std::size_t i = 0; i < summary.measures.size(); ++i)
        if (Panel panel = PanelOfMeasure(summary, i, axis).panel(); !panel.series.empty())
            plot.panels.push_back(std::move(panel));
    if (plot.panels.empty())
        throw UserError("nothing to draw: no run has a value of the measures");
    return plot;
}

} // namespace placedpar
