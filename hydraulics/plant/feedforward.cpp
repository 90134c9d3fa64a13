#include "hydraulics/plant/feedforward.hpp"

#include "hydraulics/plant/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace placedpar::hydraulics {

namespace {

double beyond_psi(const Circuit& circuit, std::size_t j, const std::vector<double>& psi,
                  const FlowConstants& constants) {
    return circuit[j].through == Through::junction ? psi[circuit[j].next] : constants.tank_psi;
}

std::vector<double> junction_pressures(const Circuit& circuit, std::span<const FlowTarget> targets,
                                       const FlowConstants& constants, double inlet_drop_psi, double bypass_drop_psi) {
    std::vector<double> psi(circuit.size());
    for (std::size_t j = circuit.size(); j-- > 0;) {
        psi[j] = targets[j].link_psi + inlet_drop_psi;
        if (circuit[j].through != Through::nowhere)
            psi[j] = std::max(psi[j], beyond_psi(circuit, j, psi, constants) + bypass_drop_psi);
        if (psi[j] > constants.relief_psi)
            throw UnfitScenario(
                fmt::format("the {} needs {:.0f} psi at its junction, but the relief valve opens at {} psi",
                            name_of(circuit[j].link), psi[j], constants.relief_psi));
    }
    return psi;
}

} // namespace

std::vector<JunctionOpening> openings_for(const Circuit& circuit, std::span<const FlowTarget> targets,
                                          const FlowConstants& constants, double inlet_drop_psi,
                                          double bypass_drop_psi) {
    assert(targets.size() == circuit.size());
    std::vector<double> psi = junction_pressures(circuit, targets, constants, inlet_drop_psi, bypass_drop_psi);
    std::vector<double> passed_on(circuit.size()); // flow that each junction receives from earlier junctions
    std::vector<JunctionOpening> openings;
    double k = constants.orifice_in3_per_s_in2_sqrt_psi;
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        double comes = circuit[j].pumps * constants.pump_in3_per_s + passed_on[j];
        double in = circuit[j].through == Through::nowhere ? comes : targets[j].inlet_in3_per_s;
        if (in > comes)
            throw UnfitScenario(fmt::format("the {} needs {} in^3/s, but only {:.1f} in^3/s reach its junction",
                                            name_of(circuit[j].link), in, comes));
        if (circuit[j].through == Through::junction)
            passed_on[circuit[j].next] += comes - in;
        double inlet_in2 = in / (k * std::sqrt(psi[j] - targets[j].link_psi));
        double bypass_in2 = (comes - in) / (k * std::sqrt(psi[j] - beyond_psi(circuit, j, psi, constants)));
        openings.push_back({targets[j].link_psi, inlet_in2, comes > in ? bypass_in2 : 0});
    }
    return openings;
}

} // namespace placedpar::hydraulics
