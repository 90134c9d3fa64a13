#pragma once

#include <boost/json/fwd.hpp>

#include <string_view>

namespace placedpar::monitor {

/// The object in a line, read once. Throws BadMessage, with the column, when it is not JSON, no object or deeper than
/// any message, and with the path, such as "links.BO.inlet_psi", when a field stands twice in one object or
/// a number is too great.
boost::json::value read_message_json(std::string_view line);

} // namespace placedpar::monitor
