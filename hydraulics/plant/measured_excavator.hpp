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

/// The ripple in the flow of an axial piston pump, a small oscillation.
struct PumpRipple {
    double amplitude;       ///< amplitude of the fundamental, relative to the mean flow
    double frequency_per_s; ///< pistons times shaft speed
};

/// A detailed model of the thesis's excavator, whose recordings this project does not have. Records of this model take
/// their place, to test the identification. The model describes the boom in configuration a, with effects that the
/// identification's model leaves out: hoses, ripple, stick friction, air in the oil and converters. Orifices, masses
/// and areas are the same in both models.
struct MeasuredExcavator {
    FlowConstants flow;
    LinkMechanics boom; ///< its friction_velocity is not used
    PumpRipple ripple;
    Hose inlet_hose, outlet_hose;
    StickFriction friction;
    AirOilMixture oil; ///< oil of the inlet side
    double oil_volume_in3;
    double drain_laminar_psi;
    PistonLeak leak;
    DriftedVoltageSpool voltage_spool; ///< the servo-valve's response to a voltage
    double dead_time_s;
    ServoCommand command;
    double sampling_period_s;  ///< time for which the control system holds a voltage
    Converter servo_converter; ///< outputs the voltage, from - range / 2 to range / 2
    double duration_s;
    double integration_step_s;
};

/// Reads the parameters that the scenario "excavator" uses (record_scenario.hpp).
MeasuredExcavator measured_excavator(const Parameters& parameters = Parameters::excavator());

/// Returns the voltage at the servo-valve: the command at the last sampling instant, through the converter.
double held_volts(const MeasuredExcavator& excavator, double time_s);

/// If a value is invalid, throws an UnfitScenario (requirement.hpp) that names the value and its valid range.
void require_valid(const MeasuredExcavator& excavator);

} // namespace placedpar::hydraulics
