#include "editor/protocol/json_members.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

namespace placedpar::editor {

namespace {

namespace json = boost::json;

constexpr std::string_view whole_number = "a whole number of at least 0";

/// Returns the result of a function such as json::value::if_array for a member.
template <class Found>
const Found& member(const json::object& object, std::string_view name,
                    const Found* (json::value::*get)() const noexcept, std::string_view wanted) {
    const json::value* value = object.if_contains(name);
    const Found* found = value ? (value->*get)() : nullptr;
    if (!found)
        throw RequestError(ErrorCode::invalid_params, fmt::format("\"{}\" must be {}", name, wanted));
    return *found;
}

} // namespace

const json::object& object_in(const json::object& object, std::string_view name) {
    return member(object, name, &json::value::if_object, "an object");
}

const json::array& array_in(const json::object& object, std::string_view name) {
    return member(object, name, &json::value::if_array, "an array");
}

std::string text_in(const json::object& object, std::string_view name) {
    return std::string(member(object, name, &json::value::if_string, "a string"));
}

std::uint64_t number_in(const json::object& object, std::string_view name) {
    const json::value* found = object.if_contains(name);
    if (const std::uint64_t* number = found ? found->if_uint64() : nullptr)
        return *number;
    const std::int64_t number = member(object, name, &json::value::if_int64, whole_number);
    if (number < 0)
        throw RequestError(ErrorCode::invalid_params, fmt::format("\"{}\" must be {}", name, whole_number));
    return static_cast<std::uint64_t>(number);
}

Position position_in(const json::object& object, std::string_view name) {
    const json::object& position = object_in(object, name);
    return {number_in(position, "line"), number_in(position, "character")};
}

} // namespace placedpar::editor
