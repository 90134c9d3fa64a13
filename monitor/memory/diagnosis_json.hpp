#pragma once

#include "identification/on_line/diagnosis.hpp"

#include <boost/json.hpp>

#include <stdexcept>

namespace placedpar::monitor {

/// The state of a diagnosis as the state file keeps it: what is read back has the same bits.
boost::json::object state_json(const identification::Diagnosis::State& state);

/// A machine's state that an earlier version wrote, and that this one cannot go on with: the machine begins anew.
class OutdatedState : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws OutdatedState, or std::runtime_error when the value is no such state or has populations of another size.
identification::Diagnosis::State state_from(const boost::json::value& value,
                                            const identification::DiagnosisSettings& settings);

} // namespace placedpar::monitor
