#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_sample.hpp"

#include <boost/container/static_vector.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// Selects whether the error contains the absolute value of the flow Q_i into the cylinder, as in equation 3.8, or the
/// signed flow, as in equation 3.11. While the pressure P falls, the error with the absolute value has a second, false
/// minimum. The false minimum is at C + 2 Q_i / |dP/dt|, where C is the true compliance.
enum class InletFlow : unsigned char { absolute, as_signed };

/// Returns the form that the thesis prints for this number of links: absolute for one link (3.8), signed for several
/// links (3.11).
inline InletFlow printed_inlet_flow(std::size_t links) {
    return links == 1 ? InletFlow::absolute : InletFlow::as_signed;
}

/// The terms of the equations below that depend only on a LinkSample. A search computes them once and uses them for all
/// trial compliances.
struct LinkTerms {
    double inlet_psi;
    double inlet_slope_psi_per_s;
    double piston_flow_in3_per_s;
    double inlet_resistance;   ///< sqrt(psi) per in^3/s
    double bypass_conductance; ///< in^3/s per sqrt(psi)
};

inline LinkTerms terms_of(const LinkSample& sample, const FlowConstants& flow) {
    return {sample.inlet_psi, sample.inlet_slope_psi_per_s, sample.piston_flow_in3_per_s,
            1 / flow.conductance(sample.inlet_in2), flow.conductance(sample.bypass_in2)};
}

/// The terms of each junction of a circuit, in the circuit's order.
using CircuitTerms = boost::container::static_vector<LinkTerms, all_links.size()>;

/// Returns the terms of each sample. REQUIRES: at most 4 samples.
inline CircuitTerms terms_of(std::span<const LinkSample> samples, const FlowConstants& flow) {
    CircuitTerms terms;
    for (const LinkSample& sample : samples)
        terms.push_back(terms_of(sample, flow));
    return terms;
}

/// One value for each junction of a circuit, in the circuit's order; entries beyond the last junction are undefined.
template <typename T>
using PerJunction = std::array<T, all_links.size()>;

/// These two functions return the flow into the cylinder (3.5), and the pressure at the junction that drives this flow
/// through the inlet (3.6).
template <typename T>
T inlet_flow(const LinkTerms& link, const T& compliance_in3_per_psi) {
    return cylinder_flow(link.piston_flow_in3_per_s, link.inlet_slope_psi_per_s, compliance_in3_per_psi);
}
template <typename T>
T junction_psi(const LinkTerms& link, const T& inlet) {
    return resisted_drop(link.inlet_resistance, inlet) + link.inlet_psi;
}

/// Returns the flow from the junction's pumps minus the flow into the cylinder.
template <typename T>
T flow_left(const Junction& junction, const T& inlet, const FlowConstants& flow, InletFlow form) {
    using std::abs;
    T taken = form == InletFlow::absolute ? T(abs(inlet)) : inlet;
    return junction.pumps * flow.pump_in3_per_s - taken;
}

/// Returns the imbalance of flow at each junction of a circuit, in in^3/s. With the true compliances and perfect
/// readings every imbalance is 0. The imbalance is the inflow minus the flow into the cylinder and the flow through the
/// bypass. No sensor measures the pressures at the junctions; equation 3.6 gives them from the flows into the
/// cylinders. If the pressure at the next junction is higher, nothing flows through the bypass.
///
/// T is double, or a class that holds several doubles and computes with all of them at once. `compliance_in3_per_psi`
/// and `terms` have one entry for each junction, in the circuit's order. REQUIRES: there are at most 4 junctions, and
/// inlet_in2 > 0 in each sample from which the terms were computed.
template <typename T>
PerJunction<T> missing_flows_in3_per_s(const Circuit& circuit, std::span<const T> compliance_in3_per_psi,
                                       const CircuitTerms& terms, const FlowConstants& flow, InletFlow form) {
    PerJunction<T> psi, missing;
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        T inlet = inlet_flow(terms[j], compliance_in3_per_psi[j]);
        psi[j] = junction_psi(terms[j], inlet);
        missing[j] = flow_left(circuit[j], inlet, flow, form);
    }
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        if (circuit[j].through == Through::nowhere)
            continue;
        bool on = circuit[j].through == Through::junction;
        T drop = on ? T(psi[j] - psi[circuit[j].next]) : T(psi[j] - flow.tank_psi);
        T past = bypass_flow(terms[j].bypass_conductance, drop);
        missing[j] -= past;
        if (on)
            missing[circuit[j].next] += past;
    }
    return missing;
}
template <typename T>
PerJunction<T> missing_flows_in3_per_s(const Circuit& circuit, std::span<const T> compliance_in3_per_psi,
                                       std::span<const LinkSample> samples, const FlowConstants& flow, InletFlow form) {
    return missing_flows_in3_per_s<T>(circuit, compliance_in3_per_psi, terms_of(samples, flow), flow, form);
}

/// Returns the imbalance of flow, in in^3/s, at the only junction of a circuit.
template <typename T>
T missing_flow_in3_per_s(const Junction& junction, const T& compliance_in3_per_psi, const LinkTerms& link,
                         const FlowConstants& flow, InletFlow form) {
    T inlet = inlet_flow(link, compliance_in3_per_psi), left = flow_left(junction, inlet, flow, form);
    if (junction.through == Through::nowhere)
        return left;
    return left - bypass_flow(link.bypass_conductance, T(junction_psi(link, inlet) - flow.tank_psi));
}

/// Returns the error that a search for compliances minimises: the sum of the absolute values of the imbalances at all
/// junctions. One junction has the error of equations 3.5 to 3.8. Two junctions in series have the error of 3.10 and
/// 3.11. For other circuits, this project extends these equations. REQUIRES: the same as missing_flows_in3_per_s().
template <typename T>
T circuit_error_in3_per_s(const Circuit& circuit, std::span<const T> compliance_in3_per_psi, const CircuitTerms& terms,
                          const FlowConstants& flow, InletFlow form) {
    using std::abs;
    if (circuit.size() == 1) // a shortcut: most searches are for one compliance
        return abs(missing_flow_in3_per_s<T>(circuit[0], compliance_in3_per_psi[0], terms[0], flow, form));
    auto missing = missing_flows_in3_per_s<T>(circuit, compliance_in3_per_psi, terms, flow, form);
    T error = abs(missing[0]);
    for (std::size_t j = 1; j < circuit.size(); ++j)
        error += abs(missing[j]);
    return error;
}
template <typename T>
T circuit_error_in3_per_s(const Circuit& circuit, std::span<const T> compliance_in3_per_psi,
                          std::span<const LinkSample> samples, const FlowConstants& flow, InletFlow form) {
    return circuit_error_in3_per_s<T>(circuit, compliance_in3_per_psi, terms_of(samples, flow), flow, form);
}

} // namespace placedpar::hydraulics
