#pragma once

#include "hydraulics/data/record.hpp"
#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

namespace placedpar::identification {

/// Adds to LinkIdentified::flags the reasons why a compliance may be wrong:
///
/// - at a bound of the search: the true value may lie beyond the bound, and a spool offset can make the best fit
/// negative;
/// - no excitation: the pressure hardly moves in the last window, so that noise decides;
/// - inconsistent: the circuit's equations miss the flow by more than the bias allows (misfit), the two halves of the
///   record disagree, the valve reading never changes, or the piston retracts while oil flows in;
/// - impossible: a pressure below vacuum, or a pressure that freezes and then jumps;
/// - uncertain: the relative standard error of least squares exceeds uncertain_share. This flag is omitted if a bound
///   or the lack of excitation has already been flagged.
///
/// All samples used are in `samples`. The excitation is judged on `window`, and the two halves of `halved` are
/// compared.
void add_flags(Identified& identified, const CircuitProblem& problem, const hydraulics::FlowConstants& flow,
               std::span<const hydraulics::CircuitSample> samples, std::span<const hydraulics::CircuitSample> window,
               std::span<const hydraulics::CircuitSample> halved, const IdentificationWay& way);

/// Flags each link if one of its readings stands out from the neighbouring readings (spike.hpp). Only readings that the
/// samples use are checked.
void flag_spikes(Identified& identified, const hydraulics::Record& record,
                 std::span<const hydraulics::CircuitSample> samples);

/// Flags the boom's compliance if the calibrated offset exceeds the sensor's resolution plus three standard errors. An
/// offset calibrated from the record itself may really be a leak: both upset the same balance of flows, so the
/// calibration would hide the leak (examples/hydraulics/faults). Negative offsets are not flagged, because no leak
/// looks like one.
void flag_calibration(Identified& identified, const SpoolOffset& found, double resolution_in);

} // namespace placedpar::identification
