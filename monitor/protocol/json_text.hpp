#pragma once

#include <boost/json/fwd.hpp>

#include <string>

namespace placedpar::monitor {

/// Works like boost::json::serialize, but writes numbers as people do: 0.5 instead of 5E-1.
std::string json_text(const boost::json::value& value);
/// Returns the text of the object with a newline.
std::string json_line(const boost::json::object& object);

} // namespace placedpar::monitor
