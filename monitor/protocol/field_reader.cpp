#include "monitor/protocol/field_reader.hpp"

#include "monitor/protocol/bad_message.hpp"
#include "text/nearest.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace placedpar::monitor {

namespace {

std::string in_words(const Range& range) {
    return fmt::format("a number from {} to {}{}{}", range.least, range.greatest, *range.unit ? " " : "", range.unit);
}

/// Returns the value as JSON, shortened for a message.
std::string quote(const boost::json::value& value) {
    std::string text = boost::json::serialize(value);
    return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

} // namespace

std::string FieldReader::path_of(std::string_view name) const {
    return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

bool FieldReader::has(std::string_view name) {
    if (std::ranges::find(asked_, name) == asked_.end())
        asked_.emplace_back(name);
    return object_.contains(name);
}

const boost::json::value& FieldReader::require(std::string_view name, const char* right) {
    if (!has(name))
        throw BadMessage(path_of(name), "it is missing", right);
    return object_.at(name);
}

double FieldReader::number(std::string_view name, const Range& range) {
    const boost::json::value& value = require(name, in_words(range).c_str());
    if (!value.is_number())
        throw BadMessage(path_of(name), fmt::format("it is {}", quote(value)), in_words(range));
    double number = value.to_number<double>();
    if (!(number >= range.least && number <= range.greatest))
        throw BadMessage(path_of(name), fmt::format("it is {}", number), in_words(range));
    return number;
}

double FieldReader::number_or(std::string_view name, const Range& range, double otherwise) {
    return has(name) ? number(name, range) : otherwise;
}

std::string FieldReader::text(std::string_view name) {
    const boost::json::value& value = require(name, "a string");
    if (!value.is_string())
        throw BadMessage(path_of(name), fmt::format("it is {}", quote(value)), "a string");
    return std::string(value.get_string());
}

std::string FieldReader::text_or(std::string_view name, std::string otherwise) {
    return has(name) ? text(name) : std::move(otherwise);
}

bool FieldReader::flag_or(std::string_view name, bool otherwise) {
    if (!has(name))
        return otherwise;
    const boost::json::value& value = object_.at(name);
    if (!value.is_bool())
        throw BadMessage(path_of(name), fmt::format("it is {}", quote(value)), "true or false");
    return value.get_bool();
}

const boost::json::array& FieldReader::array(std::string_view name) {
    const boost::json::value& value = require(name, "an array");
    if (!value.is_array())
        throw BadMessage(path_of(name), fmt::format("it is {}", quote(value)), "an array");
    return value.get_array();
}

FieldReader FieldReader::object(std::string_view name) {
    const boost::json::value& value = require(name, "an object");
    if (!value.is_object())
        throw BadMessage(path_of(name), fmt::format("it is {}", quote(value)), "an object");
    return {value.get_object(), path_of(name)};
}

std::vector<std::string> FieldReader::names() const {
    std::vector<std::string> names;
    for (const auto& field : object_)
        names.emplace_back(field.key());
    return names;
}

void FieldReader::finish() const {
    for (const std::string& name : names())
        if (std::ranges::find(asked_, name) == asked_.end()) {
            std::string meant = did_you_mean(name, asked_);
            throw BadMessage(path_of(name), "there is no such field",
                             meant.empty() ? fmt::format("one of {}", fmt::join(asked_, ", ")) : meant);
        }
}

} // namespace placedpar::monitor
