#include "app/identify/trend.hpp"
#include "hydraulics/data/clock_time.hpp"
#include "identification/on_line/population_sets.hpp"
#include "picture/plot.hpp"
#include "picture/plot_over_dates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// The x axis of a trend: dates, or the numbers of the records.
class TrendAxis {
public:
    explicit TrendAxis(const Trend& trend) : trend_(trend) {}

    double at(std::size_t record) const {
        return trend_.dated() ? *trend_.answers()[record].date_s : static_cast<double>(record + 1);
    }
    Axis axis() const {
        Axis axis{.label = trend_.dated() ? "date" : "record, in the order of the command line"};
        if (!trend_.dated()) {
            axis.from = 0.5, axis.to = static_cast<double>(trend_.answers().size()) + 0.5;
            return axis;
        }
        const double margin = std::max(0.04 * (at(trend_.answers().size() - 1) - at(0)), 3600.);
        axis.from = at(0) - margin, axis.to = at(trend_.answers().size() - 1) + margin;
        return axis;
    }

private:
    const Trend& trend_;
};

/// Returns the means between the changes, as lines.
std::vector<Series> means_of(const Trend& trend, Link link, TrendValue value, const TrendAxis& axis) {
    const std::vector<std::size_t> records = trend.records_of(link, value);
    std::vector<Series> means;
    std::size_t first = 0;
    auto add = [&](std::size_t end, double mean) {
        means.push_back({means.empty() ? "mean between changes" : "",
                         {{axis.at(records[first]), mean}, {axis.at(records[end - 1]), mean}},
                         Stroke::plain,
                         1});
        first = end;
    };
    double last = 0;
    for (const TrendChange& each : trend.changes())
        if (each.link == link && each.value == value) {
            const auto found = std::ranges::find(records, each.after);
            add(static_cast<std::size_t>(found - records.begin()), each.change.before.value);
            last = each.change.after.value;
        }
    if (first > 0)
        add(records.size(), last);
    return means;
}

/// Returns the unit as plots write it: "in³/psi".
std::string plain_unit(TrendValue value) {
    std::string unit(unit_of(value));
    if (const std::size_t cube = unit.find("^3"); cube != unit.npos)
        unit.replace(cube, 2, "³");
    return unit;
}

/// Returns "rises by 41 % after 2024-03-05".
std::string print_short(const TrendChange& change, const Trend& trend) {
    const auto& [at, before, after, probability] = change.change;
    const double by = after.value - before.value;
    const RecordAnswer& last = trend.answers()[change.before];
    return fmt::format("{} by {} after {}", by > 0 ? "rises" : "falls",
                       change.value == TrendValue::compliance
                           ? fmt::format("{:.0f} %", 100 * std::abs(by / before.value))
                           : fmt::format("{:.2g} {}", std::abs(by), plain_unit(change.value)),
                       trend.dated() ? date_text(*last.date_s) : last.record);
}

std::string title_of(const Trend& trend, Link link, TrendValue value) {
    std::string changes;
    for (const TrendChange& each : trend.changes())
        if (each.link == link && each.value == value)
            changes += (changes.empty() ? " " : ", and ") + print_short(each, trend);
    return changes.empty() ? fmt::format("{}: no change of the {} is found", name_of(link), name_of(value))
                           : fmt::format("{}: the {}{}", name_of(link), name_of(value), changes);
}

Panel trend_panel(const Trend& trend, Link link, TrendValue value) {
    const TrendAxis axis(trend);
    Panel panel{.title = title_of(trend, link, value),
                .x = axis.axis(),
                .y = {.label = fmt::format("{} [{}]", name_of(value), plain_unit(value))}};
    Series points{"record, interval of 95 %", {}, Stroke::points, 0};
    for (std::size_t record : trend.records_of(link, value)) {
        const auto [found, error] = *trend.answers()[record].of(link, value);
        points.points.push_back({axis.at(record), found});
        points.intervals.push_back({found - errors_of_interval * error, found + errors_of_interval * error});
    }
    panel.series = means_of(trend, link, value, axis);
    panel.series.insert(panel.series.begin(), std::move(points));
    return panel;
}

} // namespace

std::string trend_svg(const Trend& trend) {
    Plot plot{fmt::format("Trend over {} records", trend.answers().size()), {}};
    for (Link link : links_of(trend.links()))
        for (TrendValue value : all_trend_values) {
            const bool changed = std::ranges::any_of(
                trend.changes(), [&](const TrendChange& each) { return each.link == link && each.value == value; });
            if (changed || value == TrendValue::compliance)
                plot.panels.push_back(trend_panel(trend, link, value));
        }
    return trend.dated() ? draw_svg_over_dates(plot) : draw_svg(plot);
}

} // namespace placedpar
