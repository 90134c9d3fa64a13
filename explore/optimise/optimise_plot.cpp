#include "explore/optimise/optimise_report.hpp"

#include <algorithm>

namespace placedpar {

namespace {

/// Returns the best cost so far over the number of machines simulated, as a step curve.
Series convergence_of(const SearchCourse& course) {
    Series series{.name = course.way, .stroke = Stroke::plain};
    double best = 0;
    for (std::size_t i = 0; i < course.merits.size(); ++i) {
        if (!course.merits[i].feasible)
            continue;
        auto x = static_cast<double>(i + 1);
        double cost = course.merits[i].costs.front();
        if (!series.points.empty() && cost >= best)
            continue;
        if (!series.points.empty())
            series.points.push_back({x, best});
        series.points.push_back({x, cost});
        best = cost;
    }
    series.points.push_back({static_cast<double>(course.merits.size()), best});
    return series;
}

bool found_any(const SearchCourse& course) { return !course.front().empty(); }

Point point_of(const Merit& merit) { return {merit.costs.at(0), merit.costs.at(1)}; }

Series all_machines(const SearchCourse& course) {
    Series series{.name = "machines tried", .stroke = Stroke::points};
    for (const Merit& merit : course.merits)
        if (merit.feasible)
            series.points.push_back(point_of(merit));
    return series;
}

Series front_series(const Optimum& optimum, const SearchCourse& course) {
    Series series{.name = std::ranges::count_if(optimum.courses, found_any) > 1 ? "front, " + course.way : "front"};
    for (std::size_t place : best_of(course))
        series.points.push_back(point_of(course.merits[place]));
    return series;
}

Panel panel_of_front(const Optimum& optimum) {
    Panel panel{.x = {.label = optimum.measures[0]}, .y = {.label = optimum.measures[1]}};
    panel.series.push_back(all_machines(optimum.courses.front()));
    for (const SearchCourse& course : optimum.courses)
        if (found_any(course))
            panel.series.push_back(front_series(optimum, course));
    if (optimum.start.merit.feasible)
        panel.series.push_back(
            {.name = "as it is", .points = {point_of(optimum.start.merit)}, .stroke = Stroke::points});
    return panel;
}

Panel panel_of_convergence(const Optimum& optimum) {
    Panel panel{.x = {.label = "machines simulated"}, .y = {.label = optimum.measures[0]}};
    int colour = 0;
    for (const SearchCourse& course : optimum.courses) {
        if (!found_any(course))
            continue;
        panel.series.push_back(convergence_of(course));
        panel.series.back().colour = colour++;
    }
    if (optimum.start.merit.feasible)
        panel.marks.push_back({.name = "as it is", .y = optimum.start.merit.costs.front()});
    return panel;
}

} // namespace

Plot optimum_plot(const Optimum& optimum, const std::string& title) {
    return {.title = title,
            .panels = {optimum.measures.size() > 1 ? panel_of_front(optimum) : panel_of_convergence(optimum)}};
}

} // namespace placedpar
