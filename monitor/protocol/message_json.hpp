#pragma once

#include <boost/json/fwd.hpp>

#include <string_view>

namespace placedpar::monitor {

/// Parses a client's line, which must be a JSON object. If the line is not JSON, is not an object, or is nested deeper
/// than any message, throws BadMessage with the column. If an object has a field twice or a number is out of range,
/// throws BadMessage with the field's path, such as "links.BO.inlet_psi".
boost::json::value read_message_json(std::string_view line);

} // namespace placedpar::monitor
