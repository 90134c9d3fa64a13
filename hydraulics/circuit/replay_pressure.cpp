#include "hydraulics/circuit/replay_pressure.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/flow_split.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace placedpar::hydraulics {

namespace {

using Pressure = std::array<double, 1>;

void require_valid(std::span<const ReplaySample> record, const ReplayCircuit& circuit, double step_s) {
    if (!(circuit.inlet_compliance_in3_per_psi > 0 && step_s > 0))
        throw std::invalid_argument(
            fmt::format("the compliance of a replay is {} in^3/psi and its step {} s, expected both above 0",
                        circuit.inlet_compliance_in3_per_psi, step_s));
    for (std::size_t i = 1; i < record.size(); ++i)
        if (!(record[i].time_s > record[i - 1].time_s))
            throw std::invalid_argument(fmt::format("sample {} of the replay is at {} s, expected a time after {} s", i,
                                                    record[i].time_s, record[i - 1].time_s));
}

/// Integrates the pressure from the sample `from`, where it is `psi`, and returns the pressure at the sample `to`.
double replay_gap(const ReplaySample& from, const ReplaySample& to, const ReplayCircuit& circuit, double psi,
                  double step_s) {
    double gap_s = to.time_s - from.time_s;
    auto rate = [&](const Pressure& at, Pressure& slope, double since_s) {
        double share = since_s / gap_s;
        OrificeAreas areas = boom_orifices(std::max(std::lerp(from.spool_in, to.spool_in, share), 0.0));
        double velocity = std::lerp(from.velocity_in_per_s, to.velocity_in_per_s, share);
        double inlet = split_flow(areas.inlet_in2, areas.bypass_in2, at[0], circuit.flow).inlet_in3_per_s;
        slope[0] = (inlet - circuit.inlet_area_in2 * velocity) / circuit.inlet_compliance_in3_per_psi;
    };
    auto steps = static_cast<std::size_t>(std::ceil(gap_s / step_s * (1 - 1e-9)));
    double even_s = gap_s / static_cast<double>(steps);
    boost::numeric::odeint::runge_kutta4<Pressure> stepper;
    Pressure pressure{psi};
    for (std::size_t i = 0; i < steps; ++i)
        stepper.do_step(rate, pressure, static_cast<double>(i) * even_s, even_s);
    return pressure[0];
}

} // namespace

std::vector<double> replay_pressure(std::span<const ReplaySample> record, const ReplayCircuit& circuit,
                                    double initial_psi, double step_s) {
    require_valid(record, circuit, step_s);
    std::vector<double> pressures;
    for (std::size_t i = 0; i < record.size(); ++i)
        pressures.push_back(i == 0 ? initial_psi
                                   : replay_gap(record[i - 1], record[i], circuit, pressures.back(), step_s));
    return pressures;
}

} // namespace placedpar::hydraulics
