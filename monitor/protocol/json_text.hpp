#pragma once

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar::monitor {

/// As boost::json::serialize, but numbers as people write them.
std::string json_text(const boost::json::value& value);
/// With a newline.
std::string json_line(const boost::json::object& object);

} // namespace placedpar::monitor
