#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_sample.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// Equation 3.8 takes the absolute value of the flow into the cylinder, equation 3.11 does not. The inner
/// absolute value gives windows of falling pressure a second optimum, at C + 2 Q_i / |dP/dt|.
enum class InletFlow : unsigned char { absolute, as_signed };

/// As the thesis prints it: absolute for one link (3.8), signed for more (3.11).
inline InletFlow printed_inlet_flow(std::size_t links) {
    return links == 1 ? InletFlow::absolute : InletFlow::as_signed;
}

/// One number for each junction of a circuit, in its order; entries past the last junction mean nothing.
template <typename T>
using PerJunction = std::array<T, all_links.size()>;

/// By how much the flows at each junction of a circuit fail to balance, in in^3/s: inflow, less the flow into the
/// cylinder, less the flow through the bypass. Pressures at the junctions are not measured but estimated from the flows
/// into the cylinders (3.6). Where the next junction's estimate is higher, nothing flows through the bypass.
///
/// T is double, or several doubles at once (orifice.hpp). `compliance_in3_per_psi` and `samples` have one entry for
/// each junction, in the circuit's order. REQUIRES: at most 4 junctions, samples[j].inlet_in2 > 0.
template <typename T>
PerJunction<T> missing_flows_in3_per_s(const Circuit& circuit, std::span<const T> compliance_in3_per_psi,
                                       std::span<const LinkSample> samples, const FlowConstants& flow, InletFlow form) {
    using std::abs;
    PerJunction<T> junction_psi, missing;
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        const LinkSample& sample = samples[j];
        T inlet = cylinder_flow(sample.piston_flow_in3_per_s, sample.inlet_slope_psi_per_s, compliance_in3_per_psi[j]);
        junction_psi[j] = junction_pressure(flow.conductance(sample.inlet_in2), sample.inlet_psi, inlet);
        T taken = form == InletFlow::absolute ? T(abs(inlet)) : inlet;
        missing[j] = circuit[j].pumps * flow.pump_in3_per_s - taken;
    }
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        if (circuit[j].through == Through::nowhere)
            continue;
        bool on = circuit[j].through == Through::junction;
        T drop = on ? T(junction_psi[j] - junction_psi[circuit[j].next]) : T(junction_psi[j] - flow.tank_psi);
        T past = bypass_flow(flow.conductance(samples[j].bypass_in2), drop);
        missing[j] -= past;
        if (on)
            missing[circuit[j].next] += past;
    }
    return missing;
}

/// The sum of the absolute values of the missing flows. With one junction this is the error of equations 3.5 to
/// 3.8, with two in series the error of 3.10 and 3.11; the other circuits extend these in the same way.
/// REQUIRES: as missing_flows_in3_per_s().
template <typename T>
T circuit_error_in3_per_s(const Circuit& circuit, std::span<const T> compliance_in3_per_psi,
                          std::span<const LinkSample> samples, const FlowConstants& flow, InletFlow form) {
    using std::abs;
    auto missing = missing_flows_in3_per_s<T>(circuit, compliance_in3_per_psi, samples, flow, form);
    T error = abs(missing[0]);
    for (std::size_t j = 1; j < circuit.size(); ++j)
        error += abs(missing[j]);
    return error;
}

} // namespace placedpar::hydraulics
