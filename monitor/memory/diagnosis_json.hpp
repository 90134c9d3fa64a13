#pragma once

#include "identification/on_line/diagnosis.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar::monitor {

/// The state of a diagnosis as the state file keeps it: what is read back has the same bits. Change a State, and raise
/// the file's version (state_identity.hpp).
boost::json::value state_json(const identification::Diagnosis::State& state);

/// Throws std::runtime_error, naming the member, when the value is no such state or has populations of another size.
identification::Diagnosis::State state_from(const boost::json::value& value,
                                            const identification::DiagnosisSettings& settings);

} // namespace placedpar::monitor
