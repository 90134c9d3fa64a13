#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/leakage.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/bulk_modulus.hpp"
#include "hydraulics/plant/converter.hpp"
#include "hydraulics/plant/hose.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "hydraulics/plant/servo_command.hpp"
#include "hydraulics/plant/stick_friction.hpp"

#include <vector>

namespace placedpar::hydraulics {

/// The flow of an axial piston pump is not quite constant.
struct PumpRipple {
    double amplitude;       ///< of the flow, of the fundamental
    double frequency_per_s; ///< pistons times shaft speed
};

/// What stands in for the excavator of the thesis, whose recordings we do not have: the boom in configuration a,
/// with the effects that the model which identifies it leaves out. Where the two agree (orifices, masses, areas) it
/// reads the same rows of excavator.csv.
struct MeasuredExcavator {
    FlowConstants flow;
    LinkMechanics boom; ///< its friction_velocity does not matter here
    PumpRipple ripple;
    Hose inlet_hose, outlet_hose;
    StickFriction friction;
    AirOilMixture oil; ///< of the inlet side
    double oil_volume_in3;
    double drain_laminar_psi;
    PistonLeak leak;
    DriftedVoltageSpool voltage_spool; ///< what the servo-valve makes of a voltage
    double dead_time_s;
    ServoCommand command;
    double sampling_period_s;  ///< for which the control system holds a voltage
    Converter servo_converter; ///< makes the voltage, from - range / 2 to range / 2
    double duration_s;
    double integration_step_s;
};

/// By the rows of the record scenario `excavator` (record_scenario.hpp).
MeasuredExcavator measured_excavator(const Parameters& parameters = Parameters::excavator());

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

/// The voltage at the servo-valve: the command as it was at the last sampling instant, through the converter.
double held_volts(const MeasuredExcavator& excavator, double time_s);

/// Simulates the excavator from rest, the load held by the inlet side, the drain side at tank pressure, friction
/// relaxed. Classical Runge-Kutta method of order 4 (Boost.Odeint); one state a step, the first at time 0. Steps end
/// where the load check or the relief valve opens or shuts, where the orifices have their knees and where a leak begins
/// (event_step.hpp); friction is not smooth where the piston turns. Throws UnfitScenario (requirement.hpp) when a value
/// is out of range, or when the step is too long for the fastest of hoses, bristles and drain: it names that one and
/// the longest step that it allows.
std::vector<MeasuredState> simulate_measured_excavator(const MeasuredExcavator& excavator);

} // namespace placedpar::hydraulics
