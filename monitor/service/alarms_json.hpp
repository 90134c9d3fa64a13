#pragma once

#include "monitor/memory/entries.hpp"

#include <boost/json/fwd.hpp>

#include <string>
#include <vector>

namespace placedpar::monitor {

boost::json::array alarms_json(const std::vector<KeptAlarm>& alarms);
/// Returns the answer to the message "alarms".
std::string alarms_line(const std::vector<KeptAlarm>& alarms);

} // namespace placedpar::monitor
