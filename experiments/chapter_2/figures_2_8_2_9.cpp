#include "experiments/kit/experiment.hpp"
#include "hydraulics/plant/pd_loop.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace placedpar {

using namespace hydraulics;

namespace {

using Maybe = std::optional<double>;

/// The multiples of the compliance C: for Figure 2.8 (1), between the two figures (2), for Figure 2.9 (4), at the limit
/// of stability (6), and beyond this limit (7).
constexpr std::array factors{1.0, 2.0, 4.0, 6.0, 7.0};
using KnownFigures = std::array<Maybe, factors.size()>; // one for each multiple

// The time step is short enough for the peak and the settling time; the duration is long enough for stable loops to
// settle.
constexpr double step_s = 0.001, duration_s = 20;

std::string times_c(double factor) { return factor == 1 ? "C" : fmt::format("{:g} C", factor); }

std::vector<double> response_of(const PdLoop& loop, double until_s) {
    return step_response(loop, step_s, static_cast<std::size_t>(std::lround(until_s / step_s)) + 1);
}

Maybe of_pair(const PdLoop& loop, double Oscillation::*figure) {
    auto pair = oscillation(loop);
    return pair ? Maybe((*pair).*figure) : std::nullopt;
}

/// Returns a figure of the step response, or nullopt if the response does not settle, as at the limit of stability.
Maybe of_step(const PdLoop& loop, double StepFigures::*figure) {
    if (stability_margin(loop) < 1.0001)
        return std::nullopt;
    return figures_of(response_of(loop, duration_s), step_s).*figure;
}

Maybe damping_of(const PdLoop& loop) { return of_pair(loop, &Oscillation::damping); }
Maybe frequency_of(const PdLoop& loop) { return of_pair(loop, &Oscillation::natural_rad_per_s); }
Maybe overshoot_of(const PdLoop& loop) { return of_step(loop, &StepFigures::overshoot_percent); }
Maybe peak_time_of(const PdLoop& loop) { return of_step(loop, &StepFigures::peak_time_s); }
Maybe settling_time_of(const PdLoop& loop) { return of_step(loop, &StepFigures::settling_time_s); }
Maybe real_pole_of(const PdLoop& loop) { return poles(loop)[0].real(); }
Maybe pair_real_of(const PdLoop& loop) { return poles(loop)[2].real(); }
Maybe pair_imaginary_of(const PdLoop& loop) { return poles(loop)[2].imag(); }
Maybe margin_of(const PdLoop& loop) { return stability_margin(loop); }

/// A figure of the control loop, computed for each multiple of the compliance C. The known values were computed
/// independently of this program and are rounded to the digits given.
struct Row {
    const char* name;
    const char* unit = "";
    int decimals = 3;
    Maybe (*value)(const PdLoop&);
    KnownFigures known = {};
    KnownFigures known_as_printed = {};
    double tolerance = 0.001;
};

constexpr Row rows[]{
    {.name = "real pole", .unit = "1/s", .value = real_pole_of, .known = {-17.937, -7.980, -5.768, -5, -4.753}},
    {.name = "pair of poles, real", .unit = "1/s", .value = pair_real_of, .known = {-6.0315, -3.510, -0.866, 0, 0.234}},
    {.name = "pair, imaginary",
     .unit = "1/s",
     .value = pair_imaginary_of,
     .known = {6.8736, 9.037, 8.016, 7.0711, 6.710}},
    {.name = "damping zeta",
     .value = damping_of,
     .known = {0.660, 0.362, 0.107, 0, -0.035},
     .known_as_printed = {0.280, 0.262, 0.222, 0.178, 0.155}},
    {.name = "natural frequency", .unit = "1/s", .value = frequency_of, .known = {9.145, 9.694, 8.063, 7.071, 6.714}},
    {.name = "stability margin",
     .value = margin_of,
     .known = {6, 6.0 / 2, 6.0 / 4, 1, 6.0 / 7},
     .known_as_printed = {15.333, 7.667, 3.833, 2.556, 2.190}},
    {.name = "overshoot",
     .unit = "%",
     .decimals = 1,
     .value = overshoot_of,
     .known = {5.2, 13.1, 35.6},
     .known_as_printed = {39.9, 42.5, 48.2, 54.7, 58.1},
     .tolerance = 0.1},
    {.name = "  its time", .unit = "s", .value = peak_time_of, .known = {0.533, 0.482, 0.527}, .tolerance = 0.0015},
    {.name = "settled within 2 %",
     .unit = "s",
     .value = settling_time_of,
     .known = {0.715, 0.954, 3.742},
     .tolerance = 0.0015},
};

Comparison run(std::string name, const PdLoop& loop, KnownFigures Row::*known) {
    Comparison comparison{.name = std::move(name), .against = "known"};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < factors.size(); ++i)
            if (Maybe value = row.value(with_compliance(loop, factors[i])))
                comparison.add(cell_of(row.name, times_c(factors[i]), row.unit, (row.*known)[i], *value, row.tolerance,
                                       row.decimals));
    return comparison;
}

Series response_series(const PdLoop& loop, double factor, std::optional<int> colour = std::nullopt) {
    Series series{times_c(factor), {}, Stroke::line, colour};
    auto response = response_of(with_compliance(loop, factor), 4);
    for (std::size_t i = 0; i < response.size(); i += 20)
        series.points.push_back({static_cast<double>(i) * step_s, response[i]});
    return series;
}

Panel response_panel(std::string title, std::vector<Series> series) {
    return {std::move(title), {"time [s]", 0, 4}, {"angle θ / desired θ", 0, 1.6}, std::move(series), {{"desired", 1}}};
}

/// Returns the path of one pole while C grows from half to ten times its value.
Series locus(const PdLoop& loop, std::string name, std::size_t which, int colour) {
    constexpr int steps = 200;
    return curve({.name = std::move(name), .colour = colour}, steps, [&](int i) -> Point {
        auto pole = poles(with_compliance(loop, 0.5 * std::pow(20, static_cast<double>(i) / steps)))[which];
        return {pole.real(), pole.imag()};
    });
}

Series poles_at(const PdLoop& loop, double factor, int colour) {
    Series points{.name = "at " + times_c(factor), .stroke = Stroke::points, .colour = colour};
    for (auto pole : poles(with_compliance(loop, factor)))
        points.points.push_back({pole.real(), pole.imag()});
    return points;
}

Panel loci_panel(const PdLoop& loop) {
    Panel panel{.title = "Poles while C grows from half to ten times its value",
                .x = {"real part [1/s]", -25, 5},
                .y = {"imaginary part [1/s]", -12, 12},
                .series = {locus(loop, "real pole", 0, 7), locus(loop, "pair", 1, 5), locus(loop, "", 2, 5)}};
    int colour = 0;
    for (double factor : factors)
        panel.series.push_back(poles_at(loop, factor, colour++));
    panel.series.push_back({"limit of stability", {{0, -12}, {0, 12}}, Stroke::dashes, 6});
    return panel;
}

Plot plot_of_responses(const PdLoop& loop) {
    Panel printed = response_panel("Equation 2.9 as printed: the same loop, C and 4 C",
                                   {response_series(as_printed(loop), 1), response_series(as_printed(loop), 4)});
    return {"Step response of the P-D loop",
            {response_panel("Figure 2.8: compliance C", {response_series(loop, 1)}),
             response_panel("Figure 2.9: compliance 4 C", {response_series(loop, 4, 1)}), printed}};
}

Replay replay_figures_2_8_2_9(const ReplayContext&) {
    PdLoop loop = reference_pd_loop();
    Comparison exchanged = run("equation 2.9 with a_1 and a_2 exchanged", loop, &Row::known);
    Comparison printed = run("equation 2.9 as printed", as_printed(loop), &Row::known_as_printed);
    printed.judged = true;
    return replay_of({exchanged, printed}, {{"figures-2-8-2-9", plot_of_responses(loop)},
                                            {"pole-loci", {"The P-D loop's poles", {loci_panel(loop)}}}});
}

} // namespace

extern const Experiment figures_2_8_2_9_experiment{
    .name = "figures-2-8-2-9",
    .about = "a P-D loop's step response with the compliance C and 4 C",
    .chapter = "2",
    .number = 3,
    .run = replay_figures_2_8_2_9,
};

} // namespace placedpar
