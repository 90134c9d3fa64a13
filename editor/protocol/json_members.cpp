#include "editor/protocol/json_members.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

namespace placedpar::editor {

namespace {

namespace json = boost::json;

[[noreturn]] void refuse_member(std::string_view name, std::string_view wanted) {
    throw RequestError(ErrorCode::invalid_params, fmt::format("\"{}\" must be {}", name, wanted));
}

const json::value& member(const json::object& object, std::string_view name, std::string_view wanted) {
    const json::value* found = object.if_contains(name);
    if (!found)
        refuse_member(name, wanted);
    return *found;
}

} // namespace

const json::object& object_in(const json::object& object, std::string_view name) {
    const json::object* found = member(object, name, "an object").if_object();
    if (!found)
        refuse_member(name, "an object");
    return *found;
}

const json::array& array_in(const json::object& object, std::string_view name) {
    const json::array* found = member(object, name, "an array").if_array();
    if (!found)
        refuse_member(name, "an array");
    return *found;
}

std::string text_in(const json::object& object, std::string_view name) {
    const json::string* found = member(object, name, "a text").if_string();
    if (!found)
        refuse_member(name, "a text");
    return std::string(*found);
}

std::uint64_t number_in(const json::object& object, std::string_view name) {
    constexpr const char* wanted = "a whole number of at least 0";
    const json::value& found = member(object, name, wanted);
    if (const std::uint64_t* number = found.if_uint64())
        return *number;
    if (const std::int64_t* number = found.if_int64(); number && *number >= 0)
        return static_cast<std::uint64_t>(*number);
    refuse_member(name, wanted);
}

Position position_in(const json::object& object, std::string_view name) {
    const json::object& position = object_in(object, name);
    return {number_in(position, "line"), number_in(position, "character")};
}

} // namespace placedpar::editor
