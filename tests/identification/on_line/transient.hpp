#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/diagnosis_state.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace placedpar::identification {

/// Makes readings that fit the equations of a circuit exactly, with known compliances. Pressures and flows into the
/// cylinders are chosen, and the bypass areas are computed so that the flows of every junction balance. Pressures and
/// angles are quadratic in time, so that the slopes of 5-point lines are exact.
class Transient {
public:
    static constexpr double period_s = 0.020;

    Transient(hydraulics::Configuration configuration, hydraulics::LinkSet active,
              const hydraulics::PerLink<double>& compliance_in3_per_psi)
        : configuration_(configuration), active_(active), compliance_(compliance_in3_per_psi) {}

    hydraulics::PerLink<double> slope_psi_per_s{1800, 1400, 1600, 2000}; ///< slopes at the start
    double curvature_psi_per_s2 = -600;

    double swing_psi = 0, swing_rad_per_s = 0; ///< an additional oscillation

    ExcavatorSample sample(double start_s, std::size_t index) const {
        double t = static_cast<double>(index) * period_s;
        ExcavatorSample made{start_s + t, {}};
        for (hydraulics::LinkSet set : sets_in_use(configuration_, active_))
            read(circuit_of(configuration_, set), t, made);
        return made;
    }

private:
    double risen_psi(hydraulics::Link link, double t) const {
        return slope_psi_per_s[index_of(link)] * t + curvature_psi_per_s2 * t * t / 2 +
               swing_psi * std::sin(swing_rad_per_s * t);
    }
    static double base_psi(std::size_t position) { return 1700 - 250 * static_cast<double>(position); }

    Reading reading(hydraulics::Link link, double psi, double flow_in3_per_s, double t, ValveAreas areas) const {
        // the integral of (flow - C dP/dt)
        double piston_in3 = flow_in3_per_s * t - compliance_[index_of(link)] * risen_psi(link, t);
        double angle_rad =
            piston_in3 /
            hydraulics::link_constants(hydraulics::Parameters::excavator())[index_of(link)].piston_in3_per_rad;
        return {psi, angle_rad * 180 / std::numbers::pi, areas};
    }

    void read(const hydraulics::Circuit& circuit, double t, ExcavatorSample& sample) const {
        const hydraulics::FlowConstants& flow = hydraulics::fitted_flow_constants();
        const double k = flow.orifice_in3_per_s_in2_sqrt_psi, inlet_in2 = 0.1;
        std::array<double, 4> psi{}, into{}, junction_psi{}, arriving{};
        for (std::size_t j = 0; j < circuit.size(); ++j) {
            psi[j] = base_psi(j) + risen_psi(circuit[j].link, t); // the pressure is lower downstream
            arriving[j] += circuit[j].pumps * flow.pump_in3_per_s;
            into[j] = circuit[j].through == hydraulics::Through::nowhere ? arriving[j] : 40;
            junction_psi[j] = psi[j] + std::pow(into[j] / (k * inlet_in2), 2);
            if (circuit[j].through == hydraulics::Through::junction)
                arriving[circuit[j].next] += arriving[j] - into[j];
        }
        for (std::size_t j = 0; j < circuit.size(); ++j) {
            double below =
                circuit[j].through == hydraulics::Through::junction ? junction_psi[circuit[j].next] : flow.tank_psi;
            double past = arriving[j] - into[j];
            double bypass_in2 = past > 0 ? past / (k * std::sqrt(junction_psi[j] - below)) : 0.02;
            hydraulics::Link link = circuit[j].link;
            sample.links[index_of(link)] = reading(link, psi[j], into[j], t, {inlet_in2, bypass_in2});
        }
    }

    hydraulics::Configuration configuration_;
    hydraulics::LinkSet active_;
    hydraulics::PerLink<double> compliance_;
};

/// Feeds the samples of a transient one after another, and returns the outcomes.
inline std::vector<SampleOutcome> feed(Diagnosis& diagnosis, const Transient& transient, double start_s,
                                       std::size_t samples = 30) {
    std::vector<SampleOutcome> outcomes;
    for (std::size_t i = 0; i < samples; ++i)
        outcomes.push_back(diagnosis.take(transient.sample(start_s, i)));
    return outcomes;
}

inline const LinkEstimate& estimate_of(const Diagnosis& diagnosis, hydraulics::LinkSet set, hydraulics::Link link) {
    return diagnosis.sets().at(set).state().estimates.at(position_in(set, link));
}

} // namespace placedpar::identification
