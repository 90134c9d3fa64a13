#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/flow_constants_fit.hpp"
#include "hydraulics/circuit/steady_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

using OfPoint = std::function<double(const SteadyFlowPoint&)>;
using MaybeOfPoint = std::function<std::optional<double>(const SteadyFlowPoint&)>;

constexpr std::array pressures_psi{2030, 1830, 1630};

/// A quantity that is computed for each entry of the table. The table has a row for each flow and a column for each
/// pressure.
struct Quantity {
    const char* name;
    const char* unit;
    int decimals;
    OfPoint value;
    MaybeOfPoint figure = [](const SteadyFlowPoint&) { return std::nullopt; };
    MaybeOfPoint tolerance = [](const SteadyFlowPoint&) { return std::nullopt; };
};

MaybeOfPoint always(double value) {
    return [value](const SteadyFlowPoint&) { return value; };
}

void add_rows(Comparison& comparison, const Quantity& quantity) {
    for (const SteadyFlowPoint& point : table_2_6())
        comparison.add(cell_of(fmt::format("{} at {} in^3/s", quantity.name, point.inlet_in3_per_s),
                               fmt::format("{} psi", point.inlet_psi), quantity.unit, quantity.figure(point),
                               quantity.value(point), quantity.tolerance(point), quantity.decimals));
}

double flow_in3_per_s(const SteadyFlowPoint& point, double spool_error_in, const FlowConstants& constants) {
    return steady_boom_flow(point.spool_in + spool_error_in, point.inlet_psi, constants).inlet_in3_per_s;
}

double more_flow_percent(const SteadyFlowPoint& point, double spool_error_in, const FlowConstants& constants) {
    return 100 * (flow_in3_per_s(point, spool_error_in, constants) / flow_in3_per_s(point, 0, constants) - 1);
}

/// Returns the flow at this spool position and pressure, by a parabola through the three entries that the thesis's
/// table has for the pressure.
double tabled_in3_per_s(double spool_in, double inlet_psi) {
    std::vector<SteadyFlowPoint> column;
    std::ranges::copy_if(table_2_6(), std::back_inserter(column),
                         [=](const SteadyFlowPoint& point) { return point.inlet_psi == inlet_psi; });
    double flow = 0;
    for (const SteadyFlowPoint& at : column) {
        double share = at.inlet_in3_per_s;
        for (const SteadyFlowPoint& other : column)
            if (other.spool_in != at.spool_in)
                share *= (spool_in - other.spool_in) / (at.spool_in - other.spool_in);
        flow += share;
    }
    return flow;
}

void add_table(Comparison& comparison, const FlowConstants& constants) {
    auto spool = [=](const SteadyFlowPoint& point) {
        return boom_spool_for_flow(point.inlet_in3_per_s, point.inlet_psi, constants);
    };
    auto flow = [=](const SteadyFlowPoint& point) { return flow_in3_per_s(point, 0, constants); };
    add_rows(comparison, {"spool", "in", 5, spool, std::mem_fn(&SteadyFlowPoint::spool_in), always(2e-4)});
    add_rows(comparison, {"flow", "in^3/s", 2, flow, std::mem_fn(&SteadyFlowPoint::inlet_in3_per_s), always(0.15)});
}

void add_claims(Comparison& comparison, const FlowConstants& constants) {
    auto add_more_flow = [&](const char* name, double error_in, double tolerance_percent) {
        auto more_flow = [=](const SteadyFlowPoint& point) { return more_flow_percent(point, error_in, constants); };
        auto tabled = [=](const SteadyFlowPoint& point) {
            return 100 * (tabled_in3_per_s(point.spool_in + error_in, point.inlet_psi) / point.inlet_in3_per_s - 1);
        };
        add_rows(comparison, {name, "%", 1, more_flow, tabled, always(tolerance_percent)});
    };
    auto sensitivity = [=](double FlowSensitivity::*of) {
        return [=](const SteadyFlowPoint& point) {
            return boom_flow_sensitivity(point.spool_in, point.inlet_psi, constants).*of;
        };
    };
    // The table ends at 60 in^3/s. Most flows with a spool error are greater than 60 in^3/s, so they are extrapolated
    // from the table.
    add_more_flow("more flow for +0.02 in", 0.02, 3);
    add_more_flow("more flow for +0.01 in", 0.01, 1.5);
    add_rows(comparison, {"dQ_i/dx", "in^3/s/in", 0, sensitivity(&FlowSensitivity::to_spool_in3_per_s_in)});
    add_rows(comparison, {"dQ_i/dP_i", "in^3/s/psi", 4, sensitivity(&FlowSensitivity::to_pressure_in3_per_s_psi)});
}

/// Judges the claim "an error of 0.02 inch causes a 50% difference in flow" for the whole table. The claim is expected
/// to fail.
Comparison half_the_flow(const FlowConstants& constants) {
    Comparison comparison{.name = "the claim", .against = "claim", .judged = true};
    auto right = std::ranges::count_if(table_2_6(), [=](const SteadyFlowPoint& point) {
        return std::abs(more_flow_percent(point, 0.02, constants) - 50) <= 5;
    });
    comparison.add(at_most(
        8, compared_cell("+0.02 in makes 45 to 55 % of flow", "entries of 9", "", 9, static_cast<double>(right), 0)));
    return comparison;
}

/// A figure of a fit, and its value computed independently of this program, rounded to the digits given.
struct FitFigure {
    const char* name;
    const char* unit = "";
    int decimals = 2;
    double (*value)(const FlowConstantsFit&);
    std::optional<double> of_all, of_eight = {};
    double tolerance;
};

double k_of(const FlowConstants& constants) { return constants.orifice_in3_per_s_in2_sqrt_psi; }

using Fit = FlowConstantsFit;

constexpr FitFigure fit_figures[]{
    {.name = "k",
     .unit = "in^3/(s in^2 psi^0.5)",
     .value = [](const Fit& fit) { return k_of(fit.constants); },
     .of_all = 99.83,
     .of_eight = 99.86,
     .tolerance = 0.01},
    {.name = "  deviation of k",
     .value = [](const Fit& fit) { return k_of(fit.deviation); },
     .of_all = 0.4,
     .tolerance = 0.05},
    {.name = "Q",
     .unit = "in^3/s",
     .value = [](const Fit& fit) { return fit.constants.pump_in3_per_s; },
     .of_all = 175.08,
     .of_eight = 175.06,
     .tolerance = 0.01},
    {.name = "  deviation of Q",
     .value = [](const Fit& fit) { return fit.deviation.pump_in3_per_s; },
     .of_all = 0.4,
     .tolerance = 0.05},
    {.name = "P_e",
     .unit = "psi",
     .decimals = 1,
     .value = [](const Fit& fit) { return fit.constants.tank_psi; },
     .of_all = 16.2,
     .of_eight = 17,
     .tolerance = 0.5},
    {.name = "  deviation of P_e",
     .decimals = 1,
     .value = [](const Fit& fit) { return fit.deviation.tank_psi; },
     .of_all = 9,
     .tolerance = 0.5},
    {.name = "rms residual",
     .unit = "1e-4 in",
     .value = [](const Fit& fit) { return fit.rms_in * 1e4; },
     .of_all = 0.61,
     .of_eight = 0.38,
     .tolerance = 0.01},
};

/// Residuals of the spool's position in units of 0.0001 inch, computed independently of this program.
using Residuals = std::array<double, 9>;
constexpr Residuals known_fitted{-0.61, -0.22, -0.29, 0.65, 1.38, 0.07, -0.47, -0.50, -0.12};
constexpr Residuals known_rounded{-0.39, -0.24, -0.62, 0.82, 1.29, -0.37, -0.35, -0.66, -0.65};

void add_residuals(Comparison& comparison, const char* name, const FlowConstants& constants, const Residuals& known) {
    auto residuals = spool_residuals_in(table_2_6(), constants);
    auto index = [](const SteadyFlowPoint& point) { return static_cast<std::size_t>(&point - table_2_6().data()); };
    add_rows(comparison,
             {name, "1e-4 in", 2, [=](const SteadyFlowPoint& point) { return 1e4 * residuals[index(point)]; },
              [=](const SteadyFlowPoint& point) { return known[index(point)]; }, always(0.01)});
}

Comparison fit_comparison() {
    Comparison comparison{.name = "k, Q and P_e fitted to the spools of the table, and the residuals",
                          .against = "known",
                          .judged = true};
    std::vector<SteadyFlowPoint> eight(table_2_6().begin(), table_2_6().end());
    eight.erase(eight.begin() + 4);
    FlowConstantsFit of_all = fit_flow_constants(table_2_6(), rounded_flow_constants());
    FlowConstantsFit of_eight = fit_flow_constants(eight, rounded_flow_constants());
    for (const FitFigure& figure : fit_figures) {
        auto add = [&](const char* column, const FlowConstantsFit& fit, std::optional<double> known) {
            comparison.add(
                cell_of(figure.name, column, figure.unit, known, figure.value(fit), figure.tolerance, figure.decimals));
        };
        add("all nine", of_all, figure.of_all);
        add("without 50 at 1830 psi", of_eight, figure.of_eight);
    }
    add_residuals(comparison, "residual, fitted,", fitted_flow_constants(), known_fitted);
    add_residuals(comparison, "residual, rounded,", rounded_flow_constants(), known_rounded);
    return comparison;
}

Series computed_flow(int psi, int colour) {
    return curve({.name = fmt::format("{} psi", psi), .colour = colour}, 224, [=](int i) -> Point {
        double spool = boom_dead_band_in + i * 0.0005; // to 0.3 in
        return {spool, flow_in3_per_s({0, static_cast<double>(psi), spool}, 0, rounded_flow_constants())};
    });
}

Series tabled_flow(int psi, int colour) {
    Series points{.name = fmt::format("thesis, {} psi", psi), .stroke = Stroke::points, .colour = colour};
    for (const SteadyFlowPoint& point : table_2_6())
        if (point.inlet_psi == psi)
            points.points.push_back({point.spool_in, point.inlet_in3_per_s});
    return points;
}

/// Plots the flow against the spool's position at the three pressures, with the table's entries.
Panel flow_panel() {
    Panel panel{.title = "Flow into the boom's cylinders in the steady state",
                .x = {"spool [in]", boom_dead_band_in, 0.3},
                .y = {"flow [in³/s]", 0, 100}};
    int colour = 0;
    for (int psi : pressures_psi) {
        panel.series.push_back(computed_flow(psi, colour));
        panel.series.push_back(tabled_flow(psi, colour++));
    }
    return panel;
}

Series error_series(const SteadyFlowPoint& point) {
    return curve({.name = fmt::format("{} in³/s", point.inlet_in3_per_s)}, 120, [&](int i) -> Point {
        double error_in = (i - 60) * 0.0005;
        return {error_in, more_flow_percent(point, error_in, rounded_flow_constants())};
    });
}

/// Plots how an error of the spool's position changes flows of 40, 50 and 60 in^3/s.
Panel error_panel() {
    Panel panel{"What an error of the spool does to the flow, at 1630 psi",
                {"error of the spool [in]", -0.03, 0.03},
                {"error of the flow [%]"},
                {},
                {{"+50 %", 50}, {"+20 %", 20}}};
    for (const SteadyFlowPoint& point : table_2_6())
        if (point.inlet_psi == 1630)
            panel.series.push_back(error_series(point));
    return panel;
}

Comparison with_constants(std::string name, const FlowConstants& constants) {
    Comparison comparison{.name = std::move(name)};
    add_table(comparison, constants);
    return comparison;
}

Replay replay_table_2_6(const ReplayContext&) {
    auto rounded = with_constants("Table 2.6, with k 100, Q 175, P_e 25", rounded_flow_constants());
    add_claims(rounded, rounded_flow_constants());
    auto fitted = with_constants("Table 2.6, with k 99.83, Q 175.08, P_e 16.2", fitted_flow_constants());
    Plot plot{"Table 2.6: flow over spool and pressure", {flow_panel(), error_panel()}};
    return replay_of({rounded, half_the_flow(rounded_flow_constants()), fitted, fit_comparison()},
                     {{"table-2-6", plot}});
}

} // namespace

extern const Experiment table_2_6_experiment{
    .name = "table-2-6",
    .about = "steady flow of the boom over spool and pressure, and the effect of errors in both",
    .chapter = "2",
    .number = 1,
    .run = replay_table_2_6,
};

} // namespace placedpar
