#include "experiments/chapter_5/kit/plant_study.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace placedpar {

namespace {

struct TrackColumn {
    const char* name;
    Tracking figure;
    int decimals;
};
constexpr TrackColumn track_columns[]{{"delay to 20 %", Tracking::delay_20, 1},
                                      {"lag", Tracking::lag, 1},
                                      {"error during", Tracking::error_during, 3},
                                      {"error after", Tracking::error_after, 3},
                                      {"deviation after", Tracking::deviation_after, 4}};

/// The index of the true pole's colour; the rows have other colours.
constexpr int truth_colour = 7;

double generation_of(std::size_t point) { return 5.0 * static_cast<double>(point); }

template <class PoleAt>
void add_pole_series(Panel& panel, const std::string& name, int colour, std::size_t points, PoleAt pole_at) {
    auto time = [](int i) { return generation_of(static_cast<std::size_t>(i)); };
    int steps = static_cast<int>(points) - 1;
    panel.series.push_back(curve({.name = name, .colour = colour}, steps, [&](int i) {
        return Point{time(i), pole_at(static_cast<std::size_t>(i)).alpha};
    }));
    panel.series.push_back(curve({.name = "", .stroke = Stroke::dashes, .colour = colour}, steps, [&](int i) {
        return Point{time(i), pole_at(static_cast<std::size_t>(i)).beta};
    }));
}

/// Returns the real or imaginary part of the pole in each run, one for each seed.
std::vector<double> parts_of(const TrackRow& row, std::size_t point, double Pole::*part) {
    std::vector<double> parts;
    for (const auto& run : row.study->runs)
        parts.push_back(run[row.track].poles[point].*part);
    return parts;
}

Pole median_pole(const TrackRow& row, std::size_t point) {
    return {median(parts_of(row, point, &Pole::alpha)), median(parts_of(row, point, &Pole::beta))};
}

/// Returns the quartiles of the real part over the seeds.
BandPoint quartiles_at(const TrackRow& row, std::size_t point) {
    auto real_parts = parts_of(row, point, &Pole::alpha);
    return {generation_of(point), quantile(real_parts, 0.25), quantile(real_parts, 0.75)};
}

Band quartiles(const TrackRow& row, int colour, std::size_t points) {
    Band band{"", {}, colour};
    for (std::size_t i = 0; i < points; ++i)
        band.points.push_back(quartiles_at(row, i));
    return band;
}

/// Returns the full names of the rows. An indented name is preceded by the beginning of the last name that is not
/// indented, as in "traditional, an island at random".
std::vector<std::string> full_names(const std::vector<TrackRow>& rows) {
    std::vector<std::string> names;
    std::string above;
    for (const TrackRow& row : rows) {
        const bool is_set_in = row.name.starts_with("  ");
        if (!is_set_in)
            above = row.name.substr(0, row.name.find(", "));
        names.push_back(is_set_in ? above + ", " + row.name.substr(2) : row.name);
    }
    return names;
}

/// Returns the names without the beginning that they share: "distributed, window 24" becomes "window 24" if all names
/// begin with "distributed, ".
std::vector<std::string> names_in_legend(const std::vector<TrackRow>& rows) {
    std::vector<std::string> names = full_names(rows);
    const std::string common = names.front().substr(0, names.front().find(", ")) + ", ";
    if (names.size() > 1 && std::ranges::all_of(names, [&](const auto& name) { return name.starts_with(common); }))
        for (std::string& name : names)
            name.erase(0, common.size());
    return names;
}

template <class PoleAt>
Panel panel_of(std::string title, const std::vector<TrackRow>& rows, PoleAt pole_at) {
    Panel panel{.title = std::move(title),
                .x = {"generation", 0, 600},
                .y = {"real part (lines), imaginary part (dashes)", 0, 1}};
    const PlantStudy& first = *rows.front().study;
    std::size_t points = first.runs.front().front().poles.size();
    const std::vector<std::string> names = names_in_legend(rows);
    for (std::size_t place = 0; place < rows.size(); ++place) {
        const TrackRow& row = rows[place];
        const auto colour = static_cast<int>(place);
        if (row.study->runs.size() > 1)
            panel.bands.push_back(quartiles(row, colour, points));
        add_pole_series(panel, names[place], colour, points, [&](std::size_t i) { return pole_at(row, i); });
    }
    add_pole_series(panel, "truth", truth_colour, points, [&](std::size_t i) {
        return pole_of(a1_at(first.islands.plant.change, generation_of(i)), Plant{}.a2);
    });
    return panel;
}

} // namespace

TrackRow answer_row(const PlantStudy& study, const std::string& choice) {
    return {choice, &study, study.answer(choice)};
}

std::vector<TrackRow> study_rows(const std::vector<PlantStudy>& studies) {
    std::vector<TrackRow> rows;
    for (const PlantStudy& study : studies)
        rows.push_back({study.islands.name, &study});
    return rows;
}

Comparison tracks_comparison(std::string name, const std::vector<TrackRow>& rows) {
    Comparison comparison{.name = std::move(name), .against = "known"};
    for (const TrackRow& row : rows) {
        for (const TrackColumn& column : track_columns)
            comparison.add(
                plain_cell(row.name, column.name, "", row.study->median(row.track, column.figure), column.decimals));
        comparison.add(plain_cell(row.name, "found [%]", "", row.study->found_percent(row.track), 0));
    }
    return comparison;
}

Cell judged_delay(const TrackRow& row, double known, double tolerance) {
    double delay = row.study->median(row.track, Tracking::delay_20);
    return judged_cell(row.name, "median", "generations", known, delay, tolerance, 1);
}

std::string median_of_seeds(const ReplayContext& context) {
    return fmt::format("medians of {} seeds, quartiles of the real part", context.seeds);
}

Panel pole_panel(std::string title, const std::vector<TrackRow>& rows) {
    return panel_of(std::move(title), rows, median_pole);
}

Panel single_run_panel(std::string title, const std::vector<TrackRow>& rows) {
    return panel_of(std::move(title), rows, [](const TrackRow& row, std::size_t point) {
        return row.study->runs.front()[row.track].poles[point];
    });
}

} // namespace placedpar
