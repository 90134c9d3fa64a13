#pragma once

#include "app/exit_code.hpp"
#include "app/options/identify_options.hpp"

#include <boost/json/fwd.hpp>

namespace placedpar {

/// Identifies the compliances of an excavator's links from many records, for example of many days. Prints how the
/// compliance of each link changes over the records, and adds this trend to `json`. Throws RefusedInput and UserError.
ExitCode identify_trend(const IdentifyOptions& options, boost::json::object& json);

} // namespace placedpar
