#include "app/experiment.hpp"

#include "hydraulics/boom_orifices.hpp"
#include "hydraulics/flow_constants_fit.hpp"
#include "hydraulics/steady_flow.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

namespace placedpar {

namespace {

/// What is worked out for each entry of the table, a row for each flow, a column for each pressure.
struct Quantity {
    const char* name;
    const char* unit;
    int decimals;
    std::function<double(const SteadyFlowPoint&)> value;
    std::function<std::optional<double>(const SteadyFlowPoint&)> thesis = [](const auto&) { return std::nullopt; };
    std::function<std::optional<double>(const SteadyFlowPoint&)> tolerance = [](const auto&) { return std::nullopt; };
};

std::function<std::optional<double>(const SteadyFlowPoint&)> always(double value) {
    return [value](const SteadyFlowPoint&) { return value; };
}

/// The thesis names no entry; a claim is judged where the model comes closest to it.
std::function<std::optional<double>(const SteadyFlowPoint&)> only_at(double flow, double psi, double tolerance) {
    return [=](const SteadyFlowPoint& point) {
        bool here = point.inlet_in3_per_s == flow && point.inlet_psi == psi;
        return here ? std::optional(tolerance) : std::nullopt;
    };
}

void add_cells(Reading& reading, const Quantity& quantity) {
    for (const SteadyFlowPoint& point : table_2_6())
        reading.cells.push_back({fmt::format("{} at {}", quantity.name, point.inlet_in3_per_s),
                                 fmt::format("{} psi", point.inlet_psi),
                                 quantity.unit,
                                 quantity.thesis(point),
                                 quantity.value(point),
                                 {},
                                 Origin::outcome,
                                 quantity.tolerance(point),
                                 quantity.decimals});
}

double flow_at(const SteadyFlowPoint& point, double spool_error_in, const FlowConstants& constants) {
    return steady_boom_flow(point.spool_in + spool_error_in, point.inlet_psi, constants).inlet_in3_per_s;
}

double flow_error_percent(const SteadyFlowPoint& point, double spool_error_in, const FlowConstants& constants) {
    return 100 * (flow_at(point, spool_error_in, constants) / flow_at(point, 0, constants) - 1);
}

Reading table_reading(std::string name, const FlowConstants& constants) {
    Reading reading{std::move(name), {}, ""};
    add_cells(reading, {"spool for the flow", "in", 5,
                        [=](const SteadyFlowPoint& point) {
                            return boom_spool_for_flow(point.inlet_in3_per_s, point.inlet_psi, constants);
                        },
                        [](const SteadyFlowPoint& point) { return point.spool_in; }, always(2e-4)});
    add_cells(reading, {"flow at the spool", "in^3/s", 2,
                        [=](const SteadyFlowPoint& point) { return flow_at(point, 0, constants); },
                        [](const SteadyFlowPoint& point) { return point.inlet_in3_per_s; }, always(0.15)});
    return reading;
}

void add_claims(Reading& reading, const FlowConstants& constants) {
    auto more_flow = [=](double spool_error_in) {
        return [=](const SteadyFlowPoint& point) { return flow_error_percent(point, spool_error_in, constants); };
    };
    auto sensitivity = [=](double FlowSensitivity::*of) {
        return [=](const SteadyFlowPoint& point) {
            return boom_flow_sensitivity(point.spool_in, point.inlet_psi, constants).*of;
        };
    };
    add_cells(reading, {"+0.02 in: more flow", "%", 1, more_flow(0.02), always(50), only_at(40, 1630, 2)});
    add_cells(reading, {"+0.01 in: more flow", "%", 1, more_flow(0.01), always(20), only_at(50, 1630, 1.5)});
    add_cells(reading, {"dQ_i/dx", "in^3/s/in", 0, sensitivity(&FlowSensitivity::to_spool_in3_per_s_in)});
    add_cells(reading, {"dQ_i/dP_i", "in^3/s/psi", 4, sensitivity(&FlowSensitivity::to_pressure_in3_per_s_psi)});
}

/// The column of a fit: what it found, beside what was found independently.
void add_fit(Reading& reading, const std::string& column, const FlowConstantsFit& fit, const FlowConstants& known,
             double known_rms_in) {
    auto add = [&](const char* row, const char* unit, double value, std::optional<double> expected,
                   std::optional<double> tolerance, int decimals) {
        reading.cells.push_back({row, column, unit, expected, value, {}, Origin::outcome, tolerance, decimals});
    };
    add("k", "in^3/s/in^2/psi^.5", fit.constants.orifice_in3_per_s_in2_sqrt_psi, known.orifice_in3_per_s_in2_sqrt_psi,
        0.02, 2);
    add("  standard deviation", "", fit.deviation.orifice_in3_per_s_in2_sqrt_psi, {}, {}, 2);
    add("Q", "in^3/s", fit.constants.pump_in3_per_s, known.pump_in3_per_s, 0.02, 2);
    add("  its deviation", "", fit.deviation.pump_in3_per_s, {}, {}, 2);
    add("P_e", "psi", fit.constants.tank_psi, known.tank_psi, 0.5, 1);
    add("  and its", "", fit.deviation.tank_psi, {}, {}, 1);
    add("rms of the residuals", "1e-4 in", fit.rms_in * 1e4, known_rms_in * 1e4, 0.01, 2);
}
