#pragma once

#include "hydraulics/plant/measured_excavator.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// The true state of the measured excavator at one instant.
struct MeasuredState {
    double time_s;
    double inlet_psi;           ///< at the valve's end of the hose, where the sensor is
    double inlet_cylinder_psi;  ///< at the other end
    double outlet_psi;          ///< at the valve's end of the drain side's hose
    double outlet_cylinder_psi; ///< at the other end
    double piston_in;           ///< 0 at the start
    double velocity_in_per_s;
    double spool_in;
    double pump_in3_per_s;       ///< with its ripple
    double inlet_in3_per_s;      ///< Q_i, out of the valve
    double bypass_in3_per_s;     ///< Q_e
    double inlet_hose_in3_per_s; ///< into the cylinder
    double leak_in3_per_s;       ///< Q_l
};

/// Simulates the excavator from rest, the load held by the inlet side, the drain side at tank pressure, friction
/// relaxed. Classical Runge-Kutta method of order 4 (Boost.Odeint); one state a step, the first at time 0. Steps end
/// where the load check or the relief valve opens or shuts, where the orifices have their knees and where a leak begins
/// (event_step.hpp); friction is not smooth where the piston turns. Throws UnfitScenario (requirement.hpp) when a value
/// is out of range, or when the step is too long for the fastest of hoses, bristles and drain: it names that one and
/// the longest step that it allows.
std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator);

} // namespace placedpar::hydraulics
