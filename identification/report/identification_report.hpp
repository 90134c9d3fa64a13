#pragma once

#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar {

/// For people: a line for each link with its references, then what is flagged.
std::string print_identified(const identification::Identified& identified,
                             const identification::ComplianceSearch& prepared,
                             const identification::IdentificationWay& way);

/// For machines: everything, with the estimates sample by sample.
boost::json::object identified_json(const identification::Identified& identified,
                                    const identification::ComplianceSearch& prepared);

} // namespace placedpar
