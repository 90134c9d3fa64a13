#include "identification/on_line/link_track.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"
#include "identification/spike.hpp"

#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

void push_bounded(std::vector<double>& values, double value) {
    if (values.size() == line_fit_points)
        values.erase(values.begin());
    values.push_back(value);
}

/// If no reading comes for this many time constants of the spool, the voltage before the gap no longer matters (our
/// choice). The spool is then assumed to be at the position for the newest voltage, as at the start.
constexpr double known_for_lags = 5;

ValveAreas areas_at(double spool_in) {
    OrificeAreas areas = boom_orifices(spool_in);
    return {areas.inlet_in2, areas.bypass_in2};
}

} // namespace

void LinkTrack::restart() {
    State former = std::exchange(state_, {});
    state_.spool_in = former.spool_in;
    state_.desired_in = former.desired_in;
}

double LinkTrack::follow_spool_in(double servo_V, const LinkConstants& constants, std::optional<double> elapsed_s) {
    double desired = desired_spool_in(servo_V);
    if (state_.spool_in && elapsed_s && *elapsed_s * constants.spool_lag_per_s < known_for_lags) {
        SpoolLag spool(constants.spool_lag_per_s, *elapsed_s, *state_.spool_in);
        spool.hold(*state_.desired_in);
        state_.spool_in = spool.spool_in();
    } else
        state_.spool_in = desired;
    state_.desired_in = desired;
    return *state_.spool_in;
}

void LinkTrack::add_valve(const Reading& reading, const LinkConstants& constants, std::optional<double> elapsed_s) {
    if (const auto* servo = std::get_if<ServoVoltage>(&reading.valve)) {
        state_.sums.spool_in += follow_spool_in(servo->servo_V, constants, elapsed_s);
        return;
    }
    state_.spool_in = state_.desired_in = std::nullopt; // the spool is no longer computed from the voltage
    if (const auto* spool = std::get_if<SpoolPosition>(&reading.valve)) {
        state_.sums.spool_in += spool->spool_in;
        return;
    }
    const auto& areas = std::get<ValveAreas>(reading.valve);
    state_.sums.inlet_in2 += areas.inlet_in2;
    state_.sums.bypass_in2 += areas.bypass_in2;
}

void LinkTrack::read(const Reading& reading, const LinkConstants& constants, std::optional<double> elapsed_s) {
    const bool areas = std::holds_alternative<ValveAreas>(reading.valve);
    if (state_.sums.areas != areas)
        state_.sums = {.areas = areas};
    state_.sums.inlet_psi += reading.inlet_psi;
    state_.sums.angle_deg += reading.angle_deg;
    add_valve(reading, constants, elapsed_s);
    ++state_.sums.readings;
}

void LinkTrack::finish_sample() {
    const Sums sums = std::exchange(state_.sums, {});
    const auto count = static_cast<double>(sums.readings);
    push_bounded(state_.inlet_psi, sums.inlet_psi / count);
    push_bounded(state_.angle_deg, sums.angle_deg / count);
    const ValveAreas areas =
        sums.areas ? ValveAreas{sums.inlet_in2 / count, sums.bypass_in2 / count} : areas_at(sums.spool_in / count);
    push_bounded(state_.inlet_in2, areas.inlet_in2);
    push_bounded(state_.bypass_in2, areas.bypass_in2);
}

LinkTrack::Newest LinkTrack::newest(const LinkConstants& constants) const {
    return {state_.inlet_psi.back(), state_.inlet_in2.back(), state_.bypass_in2.back(),
            constants.piston_in3_per_deg() * state_.angle_deg.back()};
}

bool LinkTrack::spikes(double period_s) const {
    auto spike = [&](const std::vector<double>& readings, Sensor sensor) {
        return readings.size() == line_fit_points && is_spike(readings, greatest_excursion(sensor, period_s));
    };
    return spike(state_.inlet_psi, Sensor::inlet_pressure) || spike(state_.angle_deg, Sensor::angle) ||
           spike(state_.inlet_in2, Sensor::inlet_area) || spike(state_.bypass_in2, Sensor::bypass_area);
}

std::optional<LinkSample> LinkTrack::centre(const CentredLineFit& fit, const LinkConstants& constants) const {
    constexpr std::size_t middle = line_fit_points / 2;
    if (!CentredLineFit::has_slope(state_.inlet_psi.size(), middle))
        return std::nullopt;
    return LinkSample{state_.inlet_psi[middle], fit.slope_per_s(state_.inlet_psi, middle),
                      constants.piston_in3_per_deg() * fit.slope_per_s(state_.angle_deg, middle),
                      state_.inlet_in2[middle], state_.bypass_in2[middle]};
}

} // namespace placedpar::identification
