#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"

#include <cstddef>
#include <variant>
#include <vector>

namespace placedpar::hydraulics {

/// The simplified valve of B.5: it answers a step input by areas that approach their final values like
/// exp(-rate t), without a spool. Before the step the inlet and the outlet are shut.
struct TimedOrifices {
    double inlet_final_in2;  ///< a_i1
    double bypass_rest_in2;  ///< a_e0
    double bypass_final_in2; ///< a_e1
    double outlet_final_in2; ///< 0 where the drain side is left out, as the thesis does
    double rate_per_s;       ///< a_0
    double step_time_s;
};

/// A spool that is asked for `desired_in` from `time_s` on, or to go there evenly within a ramp.
struct SpoolStep {
    double time_s;
    double desired_in;
    double ramp_s = 0;
};

/// A main valve whose spool follows commands by the lag of A.2 and opens the orifices of A.3 to A.9, which
/// are the boom's: those of the other links are not printed. (voltage_spool.hpp turns voltages into commands.)
struct SpoolOrifices {
    double rest_in;               ///< the spool before the first step
    std::vector<SpoolStep> steps; ///< in order of time, each after the ramp before it
};

using LinkValve = std::variant<TimedOrifices, SpoolOrifices>;

/// B.5.
OrificeAreas areas_at(const TimedOrifices& valve, double time_s);
/// The spool that the command asks for.
double desired_in(const SpoolOrifices& valve, double time_s);
/// How many steps of the command have begun, and how many ramps have ended: while that stays the same, the command is
/// smooth.
std::size_t begun_and_ended(const LinkValve& valve, double time_s);

} // namespace placedpar::hydraulics
