#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

/// Returns text for people: for each link a line with its compliance, its standard error, and the best of all strings
/// for comparison. The flags follow, the reasons why a compliance may be wrong.
std::string print_identified(const identification::Identified& identified,
                             const identification::ComplianceSearch& prepared,
                             const identification::IdentificationWay& way);

/// Returns the results as JSON, including the estimate after each sample.
boost::json::object identified_json(const identification::Identified& identified,
                                    const identification::ComplianceSearch& prepared);

} // namespace placedpar
