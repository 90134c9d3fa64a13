#pragma once

#include "app/exit_code.hpp"
#include "app/options/identify_options.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar {

/// Evaluates all records as identify_as_service() does, prints how the compliance of each link changes, and adds the
/// trend to `json`. Throws RefusedInput and UserError.
ExitCode identify_trend(const IdentifyOptions& options, boost::json::object& json);

} // namespace placedpar
