#pragma once

#include <boost/json/fwd.hpp>

#include <string_view>

namespace placedpar::monitor {

/// Parses the object in a line. Throws BadMessage with the column if the line is not JSON, is not an object, or is
/// nested deeper than any message. Throws BadMessage with the path, such as "links.BO.inlet_psi", if an object has a
/// field twice or a number is out of range.
boost::json::value read_message_json(std::string_view line);

} // namespace placedpar::monitor
