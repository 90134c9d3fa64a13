#pragma once

#include "hydraulics/excavator_scenario.hpp"

#include <array>

namespace placedpar {

/// The numbers of the machine, all in this one place. The thesis prints next to none of them; each is marked:
///   thesis  printed there
///   fitted  follows from what is printed there
///   ours    chosen: right in size for an excavator of 18 to 20 t, and consistent with the figures printed
/// Units: inch, psi, lbf, s.

/// The boom of the single-link experiments, with its drain side.
inline constexpr LinkMachine single_boom_machine{
    32,     // A_i, both cylinders together; ours
    17,     // A_o; ours
    22.4,   // moment arm: 4 deg/s take 50 in^3/s; ours
    1000,   // M; ours
    800,    // b; ours
    6000,   // F_c; ours
    0.05,   // friction velocity; ours
    49500,  // F, 1555 psi to hold; ours
    0.0086, // C_i; thesis 3.1.3, found from the servo-valve voltage
    0.0060, // C_o; ours
    8,      // a_0; ours
};

/// The bucket where several links move (Figures 3.9 to 3.11): no drain side, damping in place of friction.
inline constexpr LinkMachine bucket_machine{
    20,     // A_i; ours
    0,      // no drain side: thesis, appendix B
    12,     // moment arm; ours
    250,    // M; ours
    2500,   // b; ours
    0,      // F_c; ours
    0.05,   // friction velocity, of no effect; ours
    34000,  // F; ours
    0.0050, // C_i; ours
    0,      // C_o, of no effect
    8,      // a_0; ours
};

/// The boom where several links move.
inline constexpr LinkMachine boom_machine{
    32,     // A_i; ours
    0,      // no drain side: thesis, appendix B
    22.4,   // moment arm; ours
    1000,   // M; ours
    2500,   // b; ours
    0,      // F_c; ours
    0.05,   // friction velocity, of no effect; ours
    49500,  // F; ours
    0.0086, // C_i; thesis 3.1.3
    0,      // C_o, of no effect
    8,      // a_0; ours
};

/// The stick where several links move.
inline constexpr LinkMachine stick_machine{
    24,     // A_i; ours
    0,      // no drain side: thesis, appendix B
    18,     // moment arm; ours
    400,    // M; ours
    2500,   // b; ours
    0,      // F_c; ours
    0.05,   // friction velocity, of no effect; ours
    38400,  // F; ours
    0.0065, // C_i; ours
    0,      // C_o, of no effect
    8,      // a_0; ours
};

/// The swing where several links move: a motor of 16 * 12 = 192 in^3/rad that works against a slope.
inline constexpr LinkMachine swing_machine{
    16,     // A_i; ours
    0,      // no drain side: thesis, appendix B
    12,     // moment arm; ours
    800,    // M; ours
    1500,   // b; ours
    0,      // F_c; ours
    0.05,   // friction velocity, of no effect; ours
    28000,  // F; ours
    0.0040, // C_i; ours
    0,      // C_o, of no effect
    8,      // a_0; ours
};

constexpr const LinkMachine& machine_of(MachineLink link) {
    constexpr std::array machines{&bucket_machine, &boom_machine, &stick_machine, &swing_machine};
    return *machines[index_of(link)];
}

/// B.5 of bucket and boom: both paths open, with some 50 in^3/s each; ours.
inline constexpr TimedOrifices bucket_orifices{
    0.100, // a_ibu1
    0.30,  // a_ebu0
    0.068, // a_ebu1
    0,     // no drain side
    8,     // a_0
    0,     // step at the start
};
inline constexpr TimedOrifices two_link_boom_orifices{
    0.096, // a_ibo1
    0.30,  // a_ebo0
    0.016, // a_ebo1
    0,     // no drain side
    8,     // a_0
    0,     // step at the start
};

/// Scenario A: the boom is held, then asked for 4 deg/s. What boom_motion.hpp simulates, here with its events.
inline ExcavatorScenario single_boom_scenario() {
    ExcavatorScenario scenario;
    SpoolStep step;
    step.time_s = 0.1;                         // ours
    step.desired_in = 0.2593;                  // 50 in^3/s at 1850 psi; fitted
    SpoolOrifices valve{0.1297, {step}};       // A.1 at 0 V; thesis
    scenario.flow = fitted_flow_constants;     // fitted
    scenario.configuration = Configuration::a; // thesis
    scenario.links = {{MachineLink::boom, single_boom_machine, valve}};
    scenario.duration_s = 1.5;            // ours
    scenario.integration_step_s = 0.0005; // ours
    return scenario;
}

/// Scenario R2, the simulation of 3.2: bucket and boom, branch 1 of configuration a, a step of both.
inline ExcavatorScenario two_link_scenario() {
    ExcavatorScenario scenario;
    scenario.flow = fitted_flow_constants;     // fitted
    scenario.configuration = Configuration::a; // thesis
    scenario.links = {{MachineLink::bucket, bucket_machine, bucket_orifices},
                      {MachineLink::boom, boom_machine, two_link_boom_orifices}};
    scenario.duration_s = 4;             // ours
    scenario.integration_step_s = 0.001; // ours
    return scenario;
}

/// What a controller asks of each link that moves, and leaves over orifices to steer with; ours.
inline constexpr double asked_in3_per_s = 50;
inline constexpr double inlet_drop_psi = 27; // what Table 2.6 leaves over the boom's inlet; fitted
inline constexpr double bypass_drop_psi = 200;

/// The links `active` in any configuration, with a step of all: B.5 with the final areas that give each its
/// flow. REQUIRES: a link is active.
ExcavatorScenario step_scenario(Configuration, LinkSet active);

} // namespace placedpar
