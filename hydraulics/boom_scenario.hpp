#pragma once

#include "hydraulics/flow_constants.hpp"

namespace placedpar {

/// The boom as a mass on a cylinder. The thesis prints the compliance and the sampling only; every other
/// value here is ours, chosen so that 4 deg/s of boom takes the 50 in^3/s at the centre of Table 2.6, and
/// right in size for an excavator of 18 to 20 t.
struct BoomMachine {
    double inlet_area_in2 = 32;                    // A_i, both cylinders together; ours
    double outlet_area_in2 = 17;                   // A_o; ours
    double moment_arm_in = 22.4;                   // piston travel per radian of boom; ours
    double mass_lbf_s2_per_in = 1000;              // M, at the piston; ours
    double damping_lbf_s_per_in = 800;             // b; ours
    double friction_lbf = 6000;                    // F_c, reached over friction_velocity; ours
    double friction_velocity_in_per_s = 0.05;      // F_c tanh(v / this): smooth through rest; ours
    double gravity_lbf = 49500;                    // F_g, 1555 psi to hold; ours
    double inlet_compliance_in3_per_psi = 0.0086;  // C_i, thesis 3.1.3, found from the servo-valve voltage
    double outlet_compliance_in3_per_psi = 0.0060; // C_o; ours
    double spool_lag_per_s = 8;                    // a_0 of A.2; ours
    double leak_in3_per_s_psi = 0;                 // k_l across the piston (leakage.hpp) ...
    double leak_start_s = 0;                       // ... from this time on
};

/// Scenario A: the boom is held, then the operator asks for 4 deg/s.
struct BoomScenario {
    FlowConstants flow = fitted_flow_constants; // fitted
    BoomMachine machine;
    double spool_at_rest_in = 0.1297;   // A.1 at 0 V, thesis
    double spool_desired_in = 0.2593;   // 50 in^3/s at 1850 psi; fitted
    double step_time_s = 0.1;           // ours
    double duration_s = 1.5;            // ours
    double integration_step_s = 0.0005; // ours
};

} // namespace placedpar
