#pragma once

#include "hydraulics/data/record.hpp"
#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

namespace placedpar::identification {

/// Says in LinkIdentified::flags why a compliance should not be believed as it stands:
///
/// - at a bound of the search: the true value may lie beyond; an offset of the spool makes it negative;
/// - no excitation: the last window's pressure hardly moves, so that noise decides;
/// - inconsistent: the circuit's equations miss the flow by more than the bias allows (misfit), the two
///   halves of the record disagree, or the valve reading never changes, or the piston goes back while oil flows in;
/// - impossible: a pressure below vacuum, or one that freezes and then jumps;
/// - uncertain: least squares leaves a standard error of more than uncertain_share. Left out where a bound or the lack
///   of excitation has already been flagged.
///
/// `samples` are all that were used, `window` the last of them.
void add_flags(Identified& identified, const CircuitProblem& problem, const hydraulics::FlowConstants& flow,
               std::span<const hydraulics::CircuitSample> samples, std::span<const hydraulics::CircuitSample> window,
               const IdentificationWay& way);

/// Flags the links of which a single reading in the record stands out from those around it (spike.hpp), where the
/// samples were made from it.
void flag_spikes(Identified& identified, const hydraulics::Record& record,
                 std::span<const hydraulics::CircuitSample> samples);

/// A spool offset that was calibrated from the record itself may really be a leak: both upset the same balance of
/// flows, so that the calibration would hide the leak (examples/hydraulics/faults). Flags the boom's compliance where
/// the offset exceeds the sensor's resolution plus three standard errors. Negative offsets are not flagged: no leak
/// looks like one.
void flag_calibration(Identified& identified, const SpoolOffset& found, double resolution_in);

} // namespace placedpar::identification
