#pragma once

#include "hydraulics/plant/measured_excavator.hpp"

#include <functional>
#include <vector>

namespace placedpar::hydraulics {

/// The true state of the detailed model of the boom (measured_excavator.hpp) at one instant.
struct MeasuredState {
    double time_s;
    double inlet_psi;           ///< at the valve's end of the hose, where the sensor is
    double inlet_cylinder_psi;  ///< at the cylinder's end of the hose
    double outlet_psi;          ///< at the valve's end of the drain side's hose
    double outlet_cylinder_psi; ///< at the cylinder's end of the drain side's hose
    double piston_in;           ///< 0 at the start
    double velocity_in_per_s;
    double spool_in;
    double pump_in3_per_s;       ///< the pump's flow, with its ripple
    double inlet_in3_per_s;      ///< Q_i, flow from the valve into the inlet hose
    double bypass_in3_per_s;     ///< Q_e, flow through the bypass
    double inlet_hose_in3_per_s; ///< flow from the inlet hose into the cylinder
    double leak_in3_per_s;       ///< Q_l, leak across the piston
};

/// Simulates the excavator from rest. At rest the inlet side holds the load, the drain side has the tank's pressure,
/// and friction exerts no force. The method is Runge-Kutta of order 4 (Boost.Odeint). Returns one state per step, the
/// first at time 0. Steps are divided where a valve opens or shuts, at knees of the orifices' functions, and where a
/// leak begins (event_step.hpp). Steps are not divided where the piston reverses, although friction is not smooth
/// there. Throws UnfitScenario (requirement.hpp) if a value is out of range, or if the step is too long for a part of
/// the model. The message names this part and its longest step.
std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator);

/// A controller: a function that returns the voltage for a sampling period, given the state at the beginning of the
/// period.
using VoltageControl = std::function<double(const MeasuredState&)>;

/// Simulates the excavator under `control` instead of MeasuredExcavator::command. The voltage passes the converter, and
/// acts after the dead time. Throws UnfitScenario also if the sampling period is not a whole multiple of the step.
std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator,
                                                       const VoltageControl& control);

} // namespace placedpar::hydraulics
