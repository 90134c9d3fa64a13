#include "monitor/service/alarms_json.hpp"

#include "monitor/protocol/json_text.hpp"

#include <boost/json.hpp>

#include <optional>
#include <sstream>

namespace placedpar::monitor {

namespace json = boost::json;

namespace {

json::value time_or_null(const std::optional<double>& time) { return time ? json::value(*time) : json::value(nullptr); }

json::array words_json(const std::string& words) {
    json::array array;
    std::istringstream in(words);
    for (std::string word; in >> word;)
        array.emplace_back(word);
    return array;
}

} // namespace

json::array alarms_json(const std::vector<KeptAlarm>& alarms) {
    json::array array;
    for (const KeptAlarm& alarm : alarms)
        array.push_back(json::object{{"machine", alarm.machine},
                                     {"alarm", alarm.kind},
                                     {"links", words_json(alarm.links)},
                                     {"text", alarm.text},
                                     {"raised_at", alarm.raised_at},
                                     {"raised_time_s", time_or_null(alarm.raised_time_s)},
                                     {"cleared_at", time_or_null(alarm.cleared_at)},
                                     {"acknowledged_at", time_or_null(alarm.acknowledged_at)},
                                     {"shelved_until", time_or_null(alarm.shelved_until)}});
    return array;
}

std::string alarms_line(const std::vector<KeptAlarm>& alarms) {
    return json_line({{"type", "alarms"}, {"alarms", alarms_json(alarms)}});
}

} // namespace placedpar::monitor
