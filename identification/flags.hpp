#pragma once

#include "hydraulics/data/record.hpp"
#include "identification/identification.hpp"
#include "identification/offset_calibration.hpp"

namespace placedpar::identification {

/// Adds to LinkIdentified::flags the reasons why an identified compliance may be wrong:
///
/// - at a bound of the search: the true value may lie beyond the bound, because a spool offset can make even a negative
///   value fit best;
/// - no excitation: the pressure hardly changes over `window`, so noise determines the answer;
/// - inconsistent: the two halves of the samples `halved` give different compliances, the valve's reading never
///   changes, the piston retracts while oil flows in, or the best individual's error of flow exceeds the root of the
///   fitness's bias;
/// - impossible: a pressure below vacuum, or a pressure that freezes and then jumps;
/// - uncertain: the standard error of least squares exceeds 10 % of the compliance (uncertain_share);
/// - unconfirmed: least squares over all samples gives another compliance (unconfirmed_flag()).
///
/// A link that is flagged for a bound or for no excitation gets neither of the last two flags. `samples` holds all
/// samples of the search.
void add_flags(Identified& identified, const CircuitProblem& problem, const hydraulics::FlowConstants& flow,
               std::span<const hydraulics::CircuitSample> samples, std::span<const hydraulics::CircuitSample> window,
               std::span<const hydraulics::CircuitSample> halved, const IdentificationWay& way);

/// For each sensor, flags the first reading that stands out from its neighbours, because no machine moves like that
/// (spike.hpp). Checks only the readings from which the samples are computed.
void flag_spikes(Identified& identified, const hydraulics::Record& record,
                 std::span<const hydraulics::CircuitSample> samples);

/// Flags the boom's compliance if the calibration found an offset greater than the sensor's resolution plus three
/// standard errors. Such an offset may really be a leak. Both change the same balance of flows, so the calibration
/// would hide the leak (examples/hydraulics/faults). A leak looks like a positive offset; negative offsets are
/// therefore not flagged.
void flag_calibration(Identified& identified, const SpoolOffset& found, double resolution_in);

} // namespace placedpar::identification
