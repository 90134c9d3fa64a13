#include "monitor/protocol/json_text.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <utility>

namespace placedpar::monitor {

namespace json = boost::json;

namespace {

void print_json(const json::value& value, std::string& text) {
    const char* separator = "";
    if (const json::object* object = value.if_object()) {
        text += '{';
        for (const auto& field : *object) {
            text += fmt::format("{}{}:", std::exchange(separator, ","), json::serialize(json::value(field.key())));
            print_json(field.value(), text);
        }
        text += '}';
    } else if (const json::array* array = value.if_array()) {
        text += '[';
        for (const json::value& each : *array) {
            text += std::exchange(separator, ",");
            print_json(each, text);
        }
        text += ']';
    } else if (const double* number = value.if_double())
        text += fmt::format("{}", *number);
    else
        text += json::serialize(value);
}

} // namespace

std::string json_text(const json::value& value) {
    std::string text;
    print_json(value, text);
    return text;
}

std::string json_line(const json::object& object) { return json_text(object) + "\n"; }

} // namespace placedpar::monitor
