#pragma once

#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

namespace placedpar {

/// Of a compliance. Ours: at a standard error of 10 % one answer in three is off by more than the thesis's 10 %.
inline constexpr double uncertain_share = 0.1;

/// Where a compliance should not be believed as it stands, a sentence each into LinkIdentified::flags:
///
/// - at a bound of the search: the true value may lie beyond; an offset of the spool makes it negative;
/// - no excitation: the last window's pressure hardly moves, so that noise decides;
/// - inconsistent: the circuit's equations miss the flow by more than the bias allows, the searches disagree,
///   or the two halves of the record do, or the valve reads the same throughout;
/// - uncertain: least squares leaves a standard error of more than uncertain_share. Not said where a bound or the want
///   of excitation says as much.
///
/// `samples` are all that were used, `window` the last of them.
void add_flags(Identified& identified, const hydraulics::CircuitProblem& problem, const hydraulics::FlowConstants& flow,
               std::span<const hydraulics::CircuitSample> samples, std::span<const hydraulics::CircuitSample> window,
               const IdentificationWay& way);

/// An offset of the spool that is found in the record itself may be a leak, which upsets the same balance of flows and
/// by it hides from the compliance (examples/14-faults). Flags the boom's compliance where the offset is more than the
/// sensor's resolution and three standard errors; not below 0, where no leak takes it.
void flag_calibration(Identified& identified, const SpoolOffset& found, double resolution_in);

} // namespace placedpar
