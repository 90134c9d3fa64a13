#pragma once

#include "app/identification/identification.hpp"

namespace placedpar {

/// Where a compliance should not be believed as it stands, a sentence each into LinkIdentified::flags:
///
/// - at a bound of the search: the true value may lie beyond; an offset of the spool makes it negative;
/// - no excitation: the last window's pressure hardly moves, so that noise decides;
/// - inconsistent: the circuit's equations miss the flow by more than the bias allows, the searches disagree,
///   or the two halves of the record do.
///
/// `samples` are all that were used, `window` the last of them.
void add_flags(Identified& identified, const CircuitProblem& problem, const FlowConstants& flow,
               std::span<const CircuitSample> samples, std::span<const CircuitSample> window,
               const IdentificationWay& way);

} // namespace placedpar
