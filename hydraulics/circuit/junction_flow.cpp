#include "hydraulics/circuit/junction_flow.hpp"

#include "hydraulics/circuit/flow_split.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace placedpar::hydraulics {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Solver {
public:
    Solver(const Circuit& circuit, std::span<const JunctionOpening> openings, const FlowConstants& constants,
           std::span<JunctionFlow> flows)
        : circuit_(circuit), openings_(openings), constants_(constants), flows_(flows) {}

    void solve() const {
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            if (circuit_[j].through != Through::junction)
                solve(j, constants_.tank_psi);
    }

private:
    struct Outlets {
        Outlet inlet, bypass;

        /// Returns the pressure above which oil flows out of the junction.
        double lowest_psi() const {
            return std::min(inlet.conductance > 0 ? inlet.psi : infinity,
                            bypass.conductance > 0 ? bypass.psi : infinity);
        }
        /// Returns the conductance of those outlets whose far side has the pressure lowest_psi().
        double lowest_conductance() const {
            double lowest = lowest_psi();
            return (inlet.psi == lowest ? inlet.conductance : 0) + (bypass.psi == lowest ? bypass.conductance : 0);
        }
        double flow(double psi) const { return flow_through(inlet, psi) + flow_through(bypass, psi); }
    };

    bool leads_to(std::size_t upstream, std::size_t junction) const {
        return circuit_[upstream].through == Through::junction && circuit_[upstream].next == junction;
    }

    bool fed_by_pumps_alone(std::size_t junction) const {
        for (std::size_t i = 0; i < junction; ++i)
            if (leads_to(i, junction))
                return false;
        return circuit_[junction].pumps > 0;
    }

    double pumped(std::size_t junction) const { return circuit_[junction].pumps * constants_.pump_in3_per_s; }

    /// Solves the upstream junctions for the pressure `psi` at this junction, and returns the flow into this junction.
    double inflow(std::size_t junction, double psi) const {
        double sum = pumped(junction);
        for (std::size_t i = 0; i < junction; ++i)
            if (leads_to(i, junction)) {
                solve(i, psi);
                sum += flows_[i].bypass_in3_per_s;
            }
        return sum;
    }

    Outlets outlets_of(std::size_t junction, double next_psi) const {
        const JunctionOpening& opening = openings_[junction];
        double bypass_in2 = circuit_[junction].through == Through::nowhere ? 0 : opening.bypass_in2;
        return {{constants_.conductance(opening.inlet_in2), opening.link_psi},
                {constants_.conductance(bypass_in2), next_psi}};
    }

    /// Solves the junction and all junctions upstream of it, with the pressure `next_psi` beyond the junction's bypass.
    void solve(std::size_t junction, double next_psi) const {
        Outlets outlets = outlets_of(junction, next_psi);
        if (fed_by_pumps_alone(junction)) {
            FlowSplit split = split_flow(outlets.inlet, outlets.bypass, pumped(junction), constants_.relief_psi);
            flows_[junction] = {split.pump_psi, split.inlet_in3_per_s, split.bypass_in3_per_s, split.relief_in3_per_s};
            return;
        }
        double most = inflow(junction, std::min(outlets.lowest_psi(), constants_.relief_psi));
        if (most <= 0)
            leave_unreached(junction, outlets);
        else
            balance(junction, outlets, most);
    }

    /// Sets the result of a junction that no flow reaches. junction_flow.hpp states which pressure it has.
    void leave_unreached(std::size_t junction, const Outlets& outlets) const {
        double before = -infinity;
        for (std::size_t i = 0; i < junction; ++i)
            if (leads_to(i, junction) && openings_[i].bypass_in2 > 0)
                before = std::max(before, flows_[i].psi);
        double drained = outlets.lowest_psi() < infinity ? outlets.lowest_psi() : constants_.tank_psi;
        flows_[junction] = {before > -infinity ? before : drained, 0, 0, 0};
    }

    /// Finds the pressure at which inflow and outflow balance, at most the relief pressure. `most` is the inflow at the
    /// lowest pressure.
    void balance(std::size_t junction, const Outlets& outlets, double most) const {
        double psi = balanced_psi(junction, outlets, most);
        double in = flow_through(outlets.inlet, psi), by = flow_through(outlets.bypass, psi);
        double rest = inflow(junction, psi) - in - by;
        bool relieving = psi == constants_.relief_psi && circuit_[junction].pumps > 0 && rest >= 0;
        if (!relieving)
            give_rest(outlets, rest, in, by);
        flows_[junction] = {psi, in, by, relieving ? rest : 0};
    }

    /// Solves for u, where the pressure is `lowest` + u^2, because the outflows are smooth functions of u at u = 0. At
    /// the greatest u, either the outlet with the lowest pressure takes the whole inflow alone, or the pressure is the
    /// relief pressure.
    double balanced_psi(std::size_t junction, const Outlets& outlets, double most) const {
        double lowest = outlets.lowest_psi(), highest = constants_.relief_psi;
        if (lowest >= highest)
            return highest;
        double relieved = std::sqrt(highest - lowest),
               greatest = std::min(most / outlets.lowest_conductance(), relieved);
        auto psi_at = [=](double u) { return u < relieved ? std::min(lowest + u * u, highest) : highest; };
        auto excess = [&](double u) { return inflow(junction, psi_at(u)) - outlets.flow(psi_at(u)); };
        double least = excess(greatest);
        if (least >= 0) // the relief valve is open, or `least` exceeds 0 by a rounding error
            return psi_at(greatest);
        std::uintmax_t iterations = 200;
        auto [below, above] = boost::math::tools::toms748_solve(
            excess, 0.0, greatest, most, least, boost::math::tools::eps_tolerance<double>(), iterations);
        return psi_at(below + (above - below) / 2);
    }

    /// Adds the flow that rounding has left over to one outlet, so that flow is conserved. The outlet with the greater
    /// conductance^2 / flow gets this rest, since its pressure drop, flow^2 / conductance^2, changes less. An outlet
    /// without flow gets nothing. If neither outlet has flow, the outlet with the lowest pressure gets the rest, which
    /// is too small to affect the pressure.
    static void give_rest(const Outlets& outlets, double rest, double& in, double& by) {
        double a = outlets.inlet.conductance, b = outlets.bypass.conductance;
        bool to_inlet = a * a * by >= b * b * in;
        if (in == 0 && by == 0)
            to_inlet = a > 0 && outlets.inlet.psi == outlets.lowest_psi();
        else if (in == 0 || by == 0)
            to_inlet = in > 0;
        double &taken = to_inlet ? in : by, &other = to_inlet ? by : in;
        taken += rest;
        if (taken < 0) {
            other = std::max(other + taken, 0.0);
            taken = 0;
        }
    }

    const Circuit& circuit_;
    std::span<const JunctionOpening> openings_;
    const FlowConstants& constants_;
    std::span<JunctionFlow> flows_;
};

} // namespace

void solve_junctions(const Circuit& circuit, std::span<const JunctionOpening> openings, const FlowConstants& constants,
                     std::span<JunctionFlow> flows) {
    assert(openings.size() == circuit.size() && flows.size() == circuit.size());
    Solver(circuit, openings, constants, flows).solve();
}

std::vector<JunctionFlow> solve_junctions(const Circuit& circuit, std::span<const JunctionOpening> openings,
                                          const FlowConstants& constants) {
    std::vector<JunctionFlow> flows(circuit.size());
    solve_junctions(circuit, openings, constants, flows);
    return flows;
}

} // namespace placedpar::hydraulics
