#pragma once

#include "hydraulics/circuit/junction_flow.hpp"
#include "hydraulics/plant/excavator_scenario.hpp"

#include <functional>
#include <vector>

namespace placedpar::hydraulics {

/// The true state of one link at one instant.
struct LinkState {
    double inlet_psi;         ///< P_i
    double outlet_psi;        ///< P_o; the tank's pressure if the drain side is left out
    double piston_in;         ///< x, 0 at the start
    double velocity_in_per_s; ///< v
    double spool_in;          ///< 0 for a valve without a spool
    OrificeAreas areas;
    JunctionFlow flow; ///< flow at the link's junction
};

struct ExcavatorState {
    double time_s;
    std::vector<LinkState> links; ///< in the scenario's order
};

/// The opening or shutting of a load check valve. Its time has the accuracy of the integration, at best about 10 ns. At
/// shorter times from the event, the pressure drop over the inlet is smaller than its rounding error.
struct CheckEvent {
    double time_s;
    Link link;
    bool opened;
};

struct ExcavatorMotion {
    std::vector<ExcavatorState> states; ///< one per integration step, the first at time 0
    std::vector<CheckEvent> checks;     ///< in order of time
};

/// Simulates a scenario from rest, with all its active links (excavator_dynamics.hpp). The equations are B.2 to B.5 or,
/// with spools, 3.1 to 3.4 and A.2 to A.9. They include load check valves, relief valves, friction and leaks. A step
/// ends where a valve opens or shuts, a curve has a knee or a command begins. The method therefore keeps its order 4
/// (event_step.hpp). At one place it does not: the drain side's equation is not smooth where its pressure crosses the
/// tank's, and no step ends there. Throws UnfitScenario (requirement.hpp) if the scenario is not valid.
ExcavatorMotion simulate_excavator(const ExcavatorScenario&);

/// Simulates the scenario in the same way, but passes each state to `show` instead of returning all states.
std::vector<CheckEvent> simulate_excavator(const ExcavatorScenario&, const std::function<void(ExcavatorState&&)>& show);

} // namespace placedpar::hydraulics
