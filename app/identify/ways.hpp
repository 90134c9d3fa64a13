#pragma once

#include "app/exit_code.hpp"
#include "app/options/identify_options.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar {

// The two ways in which `placedpar identify` takes a record. Each prints what it finds, adds it to `json`, and throws
// RefusedInput, UserError, or UnfitRecord.

/// One search over the first transient, as chapter 3 describes it, and as processes of a netlist if asked.
ExitCode identify_by_thesis(const IdentifyOptions& options, boost::json::object& json);
/// All movements, as the monitor identifies and judges them.
ExitCode identify_as_service(const IdentifyOptions& options, boost::json::object& json);

} // namespace placedpar
