#pragma once

#include "hydraulics/circuit/junction_flow.hpp"
#include "hydraulics/plant/excavator_scenario.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::hydraulics {

/// The discrete state of one link and its junction in the main valve. While this state is unchanged, the equations are
/// smooth.
struct LinkMode {
    bool inlet_open = false;  ///< the junction's pressure exceeds the link's
    bool bypass_open = false; ///< the junction's pressure exceeds the pressure beyond the bypass
    bool relieving = false;
    bool leaking = false;
    int spool_branch = 0;    ///< interval between knees of A.3 to A.9 in which the spool is
    std::size_t command = 0; ///< number of steps and ramps of the valve's command that have begun or ended

    friend bool operator==(const LinkMode&, const LinkMode&) = default;
};

/// The differential equations of an excavator with any moving links, which event_step.hpp solves to simulate the
/// excavator. For every link:
///   C_i P_i' = Q_i - A_i v - Q_l (B.2, 2.5);
///   C_o P_o' = A_o v + Q_l - Q_o (3.4, if there is a drain side);
///   M v' = A_i P_i - A_o P_o - F - friction, x' = v;
///   spool' = a_0 (desired - spool) (A.2).
/// P is a pressure, C a compliance and A an area of the piston, with index i on the inlet side and o on the outlet
/// side. Q_i and Q_o are the flows in and out, and Q_l is the leak. x and v are the piston's position and velocity, M
/// is the mass and F the load. The flows of all junctions are solved together (junction_flow.hpp).
class ExcavatorDynamics {
public:
    using State = std::vector<double>;
    using Mode = std::vector<LinkMode>; ///< in the order of the scenario's links

    /// The components of the state, for each link.
    enum Component : std::size_t { inlet_psi, outlet_psi, piston_in, velocity_in_per_s, spool_in, components };

    /// REQUIRES: a valid scenario, which outlives this object.
    explicit ExcavatorDynamics(const ExcavatorScenario&);

    /// Returns the state at the start, in which every load is held. The drain sides have the tank's pressure, the inlet
    /// pressures carry the loads, and the spools are at rest.
    State at_rest() const;
    /// Computes the derivative, and returns the mode in which the derivative is valid.
    Mode rate(const State&, State& derivative, double time_s) const;
    /// Returns the flows at each link's junction, in the order of the scenario's links.
    std::vector<JunctionFlow> flows(const State&, double time_s) const;
    OrificeAreas areas(const State&, std::size_t link, double time_s) const;

private:
    void solve_flows(const State&, double time_s, std::vector<JunctionFlow>& by_junction) const;
    LinkMode mode_of(const State&, std::size_t link, double time_s, const std::vector<JunctionFlow>& by_junction) const;
    void link_rate(const State&, std::size_t link, double time_s, double inlet_in3_per_s, State& derivative) const;

    const ExcavatorScenario& scenario_;
    Circuit circuit_;
    std::vector<std::size_t> link_at_;     ///< index of the link at each junction
    std::vector<std::size_t> junction_of_; ///< index of the junction of each link
};

} // namespace placedpar::hydraulics
