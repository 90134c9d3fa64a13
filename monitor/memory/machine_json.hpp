#pragma once

#include "identification/on_line/machine.hpp"

#include <boost/json.hpp>

namespace placedpar::monitor {

/// A machine's state as the state file keeps it: what is read back has the same bits.
boost::json::object state_json(const Machine::State& state);

/// Throws std::runtime_error when the value is no such state, or has populations of another size.
Machine::State state_from(const boost::json::value& value, const DiagnosisSettings& settings);

} // namespace placedpar::monitor
