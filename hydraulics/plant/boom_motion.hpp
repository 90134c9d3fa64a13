#pragma once

#include "hydraulics/plant/boom_scenario.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// The true state of the boom circuit at one instant.
struct BoomState {
    double time_s;
    double inlet_psi;         // P_i
    double outlet_psi;        // P_o
    double piston_in;         // x, 0 at the start
    double velocity_in_per_s; // v
    double spool_in;
};

/// Forward simulation of equations 3.1 to 3.4 with the load check, the mass on the cylinder, a first-order
/// spool and, where the machine has one, a leak across the piston (2.5), by simulate_excavator(): its steps end where
/// the load check opens, where the orifices have their knees, and where a command begins. One state a step, the first
/// at time 0: at rest, the load held, the drain side at tank pressure.
/// Throws std::invalid_argument as simulate_excavator().
std::vector<BoomState> simulate_boom(const BoomScenario& scenario);

} // namespace placedpar::hydraulics
