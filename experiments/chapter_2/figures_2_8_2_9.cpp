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

/// Multiples of C that are looked at: Figure 2.8, Figure 2.9, the limit of stability, beyond.
constexpr std::array factors{1.0, 4.0, 6.0, 7.0};

// Fine enough for the peak and the settling time; long enough for the stable loops to settle.
constexpr double step_s = 0.001, duration_s = 20;

std::string times_c(double factor) { return factor == 1 ? "C" : fmt::format("{:g} C", factor); }

std::vector<double> response_of(const PdLoop& loop, double until_s) {
    return step_response(loop, step_s, static_cast<std::size_t>(std::lround(until_s / step_s)) + 1);
}

Maybe of_pair(const PdLoop& loop, double Oscillation::*figure) {
    auto pair = oscillation(loop);
    return pair ? Maybe((*pair).*figure) : std::nullopt;
}

/// None when the response does not settle, as it does not at the limit itself.
Maybe of_step(const PdLoop& loop, double StepFigures::*figure) {
    if (stability_margin(loop) < 1.0001)
        return std::nullopt;
    return figures_of(response_of(loop, duration_s), step_s).*figure;
}

/// A figure of the loop, for each multiple of C. The known ones were worked out independently of this program, to the
/// digits given.
struct Row {
    const char* name;
    const char* unit;
    int decimals;
    Maybe (*value)(const PdLoop&);
    std::array<Maybe, 4> known;
    std::array<Maybe, 4> known_as_printed;
    double tolerance;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{{"real pole",
                                       "1/s",
                                       3,
                                       [](const PdLoop& l) { return Maybe(poles(l)[0].real()); },
                                       {-17.937, {}, -5, {}},
                                       {},
                                       0.001},
                                      {"pair of poles, real",
                                       "1/s",
                                       3,
                                       [](const PdLoop& l) { return Maybe(poles(l)[2].real()); },
                                       {-6.0315, {}, 0, 0.234},
                                       {},
                                       0.001},
                                      {"pair, imaginary",
                                       "1/s",
                                       3,
                                       [](const PdLoop& l) { return Maybe(poles(l)[2].imag()); },
                                       {6.8736, {}, 7.0711, 6.71},
                                       {},
                                       0.006},
                                      {"damping zeta",
                                       "",
                                       3,
                                       [](const PdLoop& l) { return of_pair(l, &Oscillation::damping); },
                                       {0.660, {}, 0, {}},
                                       {0.280, 0.222},
                                       0.001},
                                      {"natural frequency",
                                       "1/s",
                                       3,
                                       [](const PdLoop& l) { return of_pair(l, &Oscillation::natural_rad_per_s); },
                                       {9.145, {}, 7.071, {}},
                                       {},
                                       0.001},
                                      {"stability margin",
                                       "",
                                       3,
                                       [](const PdLoop& l) { return Maybe(stability_margin(l)); },
                                       {6, 6.0 / 4, 1, 0.857},
                                       {},
                                       0.001},
                                      {"overshoot",
                                       "%",
                                       1,
                                       [](const PdLoop& l) { return of_step(l, &StepFigures::overshoot_percent); },
                                       {5.2},
                                       {39.9, 48},
                                       0.5},
                                      {"  its time",
                                       "s",
                                       3,
                                       [](const PdLoop& l) { return of_step(l, &StepFigures::peak_time_s); },
                                       {0.533},
                                       {},
                                       0.0015},
                                      {"settled within 2 %",
                                       "s",
                                       3,
                                       [](const PdLoop& l) { return of_step(l, &StepFigures::settling_time_s); },
                                       {0.715},
                                       {},
                                       0.0015}};
    return all;
}

Reading run(std::string name, const PdLoop& loop, std::array<Maybe, 4> Row::*known) {
    Reading reading{std::move(name), {}, "", "known"};
    for (const Row& row : rows())
        for (std::size_t i = 0; i < factors.size(); ++i) {
            Maybe value = row.value(with_compliance(loop, factors[i]));
            if (!value)
                continue;
            Cell cell{row.name, times_c(factors[i]), row.unit, (row.*known)[i], *value, {}};
            cell.tolerance = cell.thesis ? Maybe(row.tolerance) : std::nullopt;
            cell.decimals = row.decimals;
            reading.cells.push_back(cell);
        }
    return reading;
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

/// The path of one pole while C grows from half to ten times.
Series locus(const PdLoop& loop, std::string name, std::size_t which, int colour) {
    Series series{std::move(name), {}, Stroke::line, colour};
    constexpr int steps = 200;
    for (int i = 0; i <= steps; ++i) {
        auto pole = poles(with_compliance(loop, 0.5 * std::pow(20, static_cast<double>(i) / steps)))[which];
        series.points.push_back({pole.real(), pole.imag()});
    }
    return series;
}

Panel loci_panel(const PdLoop& loop) {
    Panel panel{"Poles while C grows from half to ten times",
                {"real part [1/s]", -25, 5},
                {"imaginary part [1/s]", -12, 12},
                {}};
    panel.series = {locus(loop, "real pole", 0, 7), locus(loop, "pair", 1, 5), locus(loop, "", 2, 5)};
    int colour = 0;
    for (double factor : factors) {
        Series points{"at " + times_c(factor), {}, Stroke::points, colour++};
        for (auto pole : poles(with_compliance(loop, factor)))
            points.points.push_back({pole.real(), pole.imag()});
        panel.series.push_back(points);
    }
    panel.series.push_back({"limit of stability", {{0, -12}, {0, 12}}, Stroke::dashes, 6});
    return panel;
}

} // namespace

Replay replay_figures_2_8_2_9(const ReplayContext&) {
    PdLoop loop = reference_pd_loop();
    Replay replay;
    replay.readings = {run("equation 2.9 with a_1 and a_2 exchanged", loop, &Row::known),
                       run("equation 2.9 as printed", as_printed(loop), &Row::known_as_printed)};
    replay.readings.back().judged = true;
    replay.fingerprint = fingerprint_of(replay.readings);
    Panel printed = response_panel("Equation 2.9 as printed: the same loop, C and 4 C",
                                   {response_series(as_printed(loop), 1), response_series(as_printed(loop), 4)});
    replay.plots = {{"figures-2-8-2-9",
                     {"Step response of the P-D loop",
                      {response_panel("Figure 2.8: compliance C", {response_series(loop, 1)}),
                       response_panel("Figure 2.9: compliance 4 C", {response_series(loop, 4, 1)}), printed}}},
                    {"pole-loci", {"The P-D loop's poles", {loci_panel(loop)}}}};
    return replay;
}

} // namespace placedpar
