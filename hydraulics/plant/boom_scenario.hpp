#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/data/parameters.hpp"

#include <string>

namespace placedpar::hydraulics {

/// The boom as a mass on a cylinder. The thesis prints the compliance and the sampling only; excavator.csv says
/// where each value comes from.
struct BoomMachine {
    explicit BoomMachine(const Parameters& machine = Parameters::excavator())
        : inlet_area_in2(machine["boom.inlet_area"]), outlet_area_in2(machine["boom.outlet_area"]),
          moment_arm_in(machine["boom.moment_arm"]), mass_lbf_s2_per_in(machine["boom.mass"]),
          damping_lbf_s_per_in(machine["boom.damping"]), friction_lbf(machine["boom.friction"]),
          friction_velocity_in_per_s(machine["boom.friction_velocity"]), gravity_lbf(machine["boom.gravity"]),
          inlet_compliance_in3_per_psi(machine["boom.inlet_compliance"]),
          outlet_compliance_in3_per_psi(machine["boom.outlet_compliance"]), spool_lag_per_s(machine["boom.spool_lag"]) {
    }

    double inlet_area_in2;                // A_i, both cylinders together
    double outlet_area_in2;               // A_o
    double moment_arm_in;                 // piston travel per radian of boom
    double mass_lbf_s2_per_in;            // M, at the piston
    double damping_lbf_s_per_in;          // b
    double friction_lbf;                  // F_c, reached over friction_velocity
    double friction_velocity_in_per_s;    // F_c tanh(v / this): smooth through rest
    double gravity_lbf;                   // F_g
    double inlet_compliance_in3_per_psi;  // C_i
    double outlet_compliance_in3_per_psi; // C_o
    double spool_lag_per_s;               // a_0 of A.2
};

/// The boom is held, then the operator asks for 4 deg/s. Scenario A at once; other scenarios by the rows of another
/// name.
struct BoomScenario {
    explicit BoomScenario(const Parameters& parameters = Parameters::excavator(),
                          const std::string& scenario = "scenario_a")
        : flow(flow_constants(parameters)), machine(parameters), leak_in3_per_s_psi(parameters["fault.leak"]),
          leak_start_s(parameters["fault.leak_start"]), spool_at_rest_in(parameters[scenario + ".spool_at_rest"]),
          spool_desired_in(parameters[scenario + ".spool_desired"]), step_time_s(parameters[scenario + ".step_time"]),
          duration_s(parameters[scenario + ".duration"]),
          integration_step_s(parameters[scenario + ".integration_step"]), ramp_s(parameters[scenario + ".spool_ramp"]) {
    }

    FlowConstants flow;
    BoomMachine machine;
    double leak_in3_per_s_psi; // k_l across the piston, from leak_start_s on
    double leak_start_s;
    double spool_at_rest_in;
    double spool_desired_in;
    double step_time_s;
    double duration_s;
    double integration_step_s;
    double ramp_s; // in which the spool's command goes from rest to desired; 0: a step
};

} // namespace placedpar::hydraulics
