#pragma once

#include "hydraulics/circuit/boom_orifices.hpp"

#include <cstddef>
#include <variant>
#include <vector>

namespace placedpar::hydraulics {

/// The simplified valve of equation B.5, which has no spool. Until `step_time_s` the inlet and the outlet are shut.
/// Then all areas approach their final values; the difference falls like exp(-`rate_per_s` t).
struct TimedOrifices {
    double inlet_final_in2;  ///< a_i1
    double bypass_rest_in2;  ///< a_e0
    double bypass_final_in2; ///< a_e1
    double outlet_final_in2; ///< 0 if the drain side is left out, as in the thesis
    double rate_per_s;       ///< a_0
    double step_time_s;
};

/// A command that changes the desired spool position to `desired_in`, by a step at `time_s` or by a linear ramp from
/// `time_s` on.
struct SpoolStep {
    double time_s;
    double desired_in;
    double ramp_s = 0;
};

/// A valve whose spool follows commands with the lag of equation A.2, and opens the orifices by equations A.3 to A.9.
/// The thesis prints these equations for the boom only; this program uses them for every link.
struct SpoolOrifices {
    double rest_in;               ///< spool position before the first step
    std::vector<SpoolStep> steps; ///< in order of time; each begins after the previous ramp has ended
};

using LinkValve = std::variant<TimedOrifices, SpoolOrifices>;

/// Returns the areas at this time, by equation B.5.
OrificeAreas areas_at(const TimedOrifices& valve, double time_s);
/// Returns the spool position that the command demands.
double desired_in(const SpoolOrifices& valve, double time_s);
/// Returns the number of steps that have begun plus the number of ramps that have ended. While this number is
/// unchanged, the command is smooth, so that a solver can tell where its steps must end.
std::size_t begun_and_ended(const LinkValve& valve, double time_s);

} // namespace placedpar::hydraulics
