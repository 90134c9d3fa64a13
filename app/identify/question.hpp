#pragma once

#include "app/options/identify_options.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/record_table.hpp"
#include "hydraulics/data/sampling.hpp"
#include "text/diagnostic.hpp"

#include <boost/json/fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

// What both ways to identify ask of a record.

std::optional<hydraulics::AreasFrom> areas_asked(const IdentifyOptions& options);
/// Of a number of inches. Throws UserError for anything else.
double offset_asked(const std::string& text);
/// Inlet pressure and angle of these links, and what their areas come from; `links` is given the channels there are.
hydraulics::RecordNeeds needs_of(const IdentifyOptions& options,
                                 std::function<hydraulics::LinkSet(const hydraulics::ChannelSet&)> links);

/// How the record's readings were averaged.
boost::json::object sampling_json(const hydraulics::Sampling& sampling);
boost::json::array warnings_json(const std::vector<Diagnostic>& warnings);

} // namespace placedpar
