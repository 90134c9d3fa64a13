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

/// The voltage at the servo-valve: the command as it was at the last sampling instant, through the converter.
double held_volts(const MeasuredExcavator& excavator, double time_s);

/// Throws UnfitScenario (requirement.hpp), which says which value cannot be simulated, and what is expected.
void require_valid(const MeasuredExcavator& excavator);

} // namespace placedpar::hydraulics
