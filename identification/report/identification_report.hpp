#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

/// Returns text for people: a line for each link with its references, then the flags.
std::string print_identified(const identification::Identified& identified,
                             const identification::ComplianceSearch& prepared,
                             const identification::IdentificationWay& way);

/// Returns everything as JSON, with the estimates sample by sample.
boost::json::object identified_json(const identification::Identified& identified,
                                    const identification::ComplianceSearch& prepared);

} // namespace placedpar
