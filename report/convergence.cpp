#include "report/convergence.hpp"

#include "text/statistics.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t most_points = 480;

std::size_t generations_of_all(const ConvergenceCurve& curve) {
    if (curve.runs.empty() || std::ranges::any_of(curve.runs, &std::vector<double>::empty))
        throw std::invalid_argument(fmt::format("the curve \"{}\" has no generations to draw", curve.name));
    return std::ranges::min_element(curve.runs, {}, &std::vector<double>::size)->size();
}

/// Returns the indices of the drawn generations: all, or every second, third and so on. The last generation is always
/// drawn.
std::vector<std::size_t> drawn(std::size_t generations) {
    std::size_t step = (generations + most_points - 1) / most_points;
    std::vector<std::size_t> some;
    for (std::size_t g = 0; g < generations; g += step)
        some.push_back(g);
    if (some.back() != generations - 1)
        some.push_back(generations - 1);
    return some;
}

std::vector<double> at_generation(const ConvergenceCurve& curve, std::size_t generation) {
    std::vector<double> values;
    for (const auto& run : curve.runs)
        values.push_back(run[generation]);
    return values;
}

void draw_curve(const ConvergenceCurve& curve, Panel& panel) {
    Series middle{curve.name, {}, curve.stroke, curve.colour};
    Band around{"", {}, curve.colour};
    for (std::size_t g : drawn(generations_of_all(curve))) {
        auto x = static_cast<double>(curve.first + g);
        auto values = at_generation(curve, g);
        double half = median(values);
        double low = quantile(values, 0.25), high = quantile(values, 0.75);
        if (std::isfinite(half))
            middle.points.push_back({x, half});
        if (std::isfinite(low) && std::isfinite(high))
            around.points.push_back({x, low, high});
    }
    if (!middle.points.empty())
        panel.series.push_back(std::move(middle));
    if (curve.runs.size() > 1 && curve.stroke != Stroke::points && !around.points.empty())
        panel.bands.push_back(std::move(around));
}

/// Selects the generations of a log that are drawn together: the generations of all searches, or of one search.
struct DrawnSearch {
    std::string title; ///< "" if there is only one search
    std::optional<std::size_t> search;
    std::span<const LoggedGeneration> of(const GenerationLog& log) const {
        return search ? log.of(*search) : log.of_all();
    }
};

std::vector<DrawnSearch> drawn_searches(const GenerationLog& log) {
    if (log.compares())
        return {{"", std::nullopt}};
    if (log.searches().size() == 1)
        return {{"", 0}};
    std::vector<DrawnSearch> each;
    for (std::size_t i = 0; i < log.searches().size(); ++i)
        each.push_back({log.searches()[i] + ": ", i});
    return each;
}

ConvergenceCurve curve_of(std::string name, std::span<const SeededLog> logs, const DrawnSearch& searches,
                          double LoggedGeneration::*quantity, int colour) {
    ConvergenceCurve curve{std::move(name), {}, colour};
    curve.first = logs.front().log.first(); // the first generation does not depend on the seed
    for (const SeededLog& each : logs) {
        auto& run = curve.runs.emplace_back();
        for (const LoggedGeneration& generation : searches.of(each.log))
            run.push_back(generation.*quantity);
        if (run.empty())
            throw UserError(fmt::format("nothing to draw: with seed {} some search made no generation", each.seed));
    }
    return curve;
}

/// Returns where the axis of a rising quantity begins. Returns nothing if gnuplot may choose the beginning. Leaves out
/// the lowest twentieth of the points, often the first generations, if these points would take more than half of the
/// height.
std::optional<double> beginning_of_axis(const Panel& panel) {
    std::vector<double> values;
    for (const Series& series : panel.series)
        for (const Point& point : series.points)
            values.push_back(point.y);
    auto [least, greatest] = std::ranges::minmax(values);
    double low = quantile(values, 0.05), margin = 0.05 * (greatest - low);
    if (low - least <= greatest - low)
        return std::nullopt;
    return low - margin;
}

bool is_positive(std::span<const ConvergenceCurve> curves) {
    for (const ConvergenceCurve& curve : curves)
        for (const auto& run : curve.runs)
            if (std::ranges::min(run) <= 0)
                return false;
    return true;
}

using Curves = std::vector<ConvergenceCurve>;

/// The data of curves: the selected searches in logs of several seeds.
struct DrawnLogs {
    const DrawnSearch& searches;
    std::span<const SeededLog> logs;

    ConvergenceCurve curve(const char* name, double LoggedGeneration::*quantity, int colour,
                           Stroke stroke = Stroke::line) const {
        ConvergenceCurve curve = curve_of(name, logs, searches, quantity, colour);
        curve.stroke = stroke;
        return curve;
    }
    std::string title(const char* quantity) const {
        std::string seeds = logs.size() == 1 ? fmt::format("seed {}", logs.front().seed)
                                             : fmt::format("medians and quartiles of {} seeds", logs.size());
        return fmt::format("{}{}, {}", searches.title, quantity, seeds);
    }
};

/// Draws the mean fitness as points without quartiles. A few individuals with a very low fitness make the mean jump,
/// and the jumps of a line or a band would hide the best fitness.
Panel fitness_panel(const DrawnLogs& drawn) {
    Curves curves{drawn.curve("mean", &LoggedGeneration::mean, 1, Stroke::points),
                  drawn.curve("best", &LoggedGeneration::best, 0)};
    Panel panel = convergence_panel(drawn.title("fitness"), "fitness", curves);
    panel.y.from = beginning_of_axis(panel);
    return panel;
}

Panel objective_panel(const DrawnLogs& drawn, bool minimised) {
    Curves curves{drawn.curve("best so far", &LoggedGeneration::best_so_far, 0),
                  drawn.curve("mean", &LoggedGeneration::mean, 1)};
    Panel panel = convergence_panel(drawn.title("objective"), "objective", curves);
    if (panel.series.empty())
        throw UserError("nothing to draw: no individual has a finite objective");
    panel.y.logarithmic = minimised && is_positive(curves);
    return panel;
}

Panel diversity_panel(const DrawnLogs& drawn) {
    Curves curves{drawn.curve("in a population", &LoggedGeneration::diversity, 2)};
    if (!drawn.searches.search)
        curves.push_back(drawn.curve("between them", &LoggedGeneration::between, 3));
    Panel panel = convergence_panel(drawn.searches.title + "diversity", "mean distance / greatest", curves);
    panel.y.from = 0;
    return panel;
}

void add_panels(const DrawnLogs& drawn, Plot& plot) {
    std::size_t search = drawn.searches.search.value_or(0);
    const GenerationLog& log = drawn.logs.front().log;
    plot.panels.push_back(log.has_objective(search) ? objective_panel(drawn, log.minimises(search))
                                                    : fitness_panel(drawn));
    plot.panels.push_back(diversity_panel(drawn));
}

} // namespace

Panel convergence_panel(std::string title, std::string label, std::span<const ConvergenceCurve> curves) {
    Panel panel{std::move(title), {"generation"}, {std::move(label)}};
    for (const ConvergenceCurve& curve : curves)
        draw_curve(curve, panel);
    return panel;
}

Plot convergence_plot(std::string title, std::span<const SeededLog> logs) {
    Plot plot{std::move(title), {}};
    for (const DrawnSearch& searches : drawn_searches(logs.front().log))
        add_panels({searches, logs}, plot);
    return plot;
}

} // namespace placedpar
