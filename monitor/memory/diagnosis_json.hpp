#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/diagnosis_state.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar::monitor {

/// Returns the state of a diagnosis in the form that the state file stores. Reading this form back gives the same bits.
/// A change of any State type needs a new file version (state_identity.hpp).
boost::json::value state_json(const identification::Diagnosis::State& state);

/// Reads a state that state_json() has written. Throws std::runtime_error, which names the member, if the value is not
/// a valid state, or if its populations have another size than the settings require.
identification::Diagnosis::State state_from(const boost::json::value& value,
                                            const identification::DiagnosisSettings& settings);

} // namespace placedpar::monitor
