#pragma once

#include "hydraulics/data/record.hpp"
#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

namespace placedpar::identification {

/// Adds to LinkIdentified::flags the reasons why a compliance may be wrong:
///
/// - at a bound of the search: the true value may lie beyond the bound, and a spool offset can make the best fit
/// negative;
/// - no excitation: the pressure hardly changes over `window`, so noise determines the answer;
/// - inconsistent: the best individual's flow error exceeds the square root of the bias of the fitness (misfit), the
///   two halves of the samples `halved` disagree, the valve reading never changes, or the piston retracts while oil
///   flows in;
/// - impossible: a pressure below vacuum, or a pressure that freezes and then jumps;
/// - uncertain: the relative standard error of least squares exceeds uncertain_share;
/// - unconfirmed: least squares over all samples, if it was computed, does not confirm the answer (unconfirmed_flag()).
///
/// The last two flags are omitted if a bound or the lack of excitation has already been flagged. `samples` holds all
/// samples that were used.
void add_flags(Identified& identified, const CircuitProblem& problem, const hydraulics::FlowConstants& flow,
               std::span<const hydraulics::CircuitSample> samples, std::span<const hydraulics::CircuitSample> window,
               std::span<const hydraulics::CircuitSample> halved, const IdentificationWay& way);

/// For each sensor, flags the first reading that stands out from its neighbours (spike.hpp). Checks only the readings
/// from which the samples are computed.
void flag_spikes(Identified& identified, const hydraulics::Record& record,
                 std::span<const hydraulics::CircuitSample> samples);

/// Flags the boom's compliance if the calibrated offset exceeds the sensor's resolution plus three standard errors. An
/// offset calibrated from the record itself may really be a leak: a leak and an offset change the same balance of
/// flows, so the calibration would hide the leak (examples/hydraulics/faults). Negative offsets are not flagged,
/// because a leak looks like a positive offset.
void flag_calibration(Identified& identified, const SpoolOffset& found, double resolution_in);

} // namespace placedpar::identification
