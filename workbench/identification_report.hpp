#pragma once

#include "identification/identification.hpp"
#include "identification/record_problem.hpp"

#include <boost/json/object.hpp>

#include <string>

namespace placedpar {

/// For people: a line for each link with its spread and references, then what is flagged.
std::string print_identified(const Identified& identified, const RecordProblem& prepared, const IdentificationWay& way);

/// For machines: everything, with the estimates sample by sample.
boost::json::object identified_json(const Identified& identified, const RecordProblem& prepared,
                                    const IdentificationWay& way);

} // namespace placedpar
