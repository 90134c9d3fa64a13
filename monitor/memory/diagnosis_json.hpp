#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/diagnosis_state.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar::monitor {

/// Returns the state of a diagnosis in the form that the state file stores. state_from() reads the same bits back. If
/// any State type changes, the state file needs a new version number (state_identity.hpp).
boost::json::value state_json(const identification::Diagnosis::State& state);

/// Reads a state that state_json() has written. Throws std::runtime_error if the value is not a valid state, or if its
/// populations have another size than in the settings. The error names the wrong member.
identification::Diagnosis::State state_from(const boost::json::value& value,
                                            const identification::DiagnosisSettings& settings);

} // namespace placedpar::monitor
