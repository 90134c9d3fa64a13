#pragma once

#include "text/positions.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace placedpar::editor {

/// Lists error codes of JSON-RPC and of the Language Server Protocol.
enum class ErrorCode : int {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    internal_error = -32603,
    not_initialized = -32002,
    request_failed = -32803
};

/// Reports that an editor's request cannot be answered. The editor gets the code and the text.
struct RequestError : std::runtime_error {
    RequestError(ErrorCode error, const std::string& why) : std::runtime_error(why), code(error) {}
    ErrorCode code;
};

// These functions return the member `name` of a JSON object. They throw RequestError if the member is missing or has
// another type.

const boost::json::object& object_in(const boost::json::object&, std::string_view name);
const boost::json::array& array_in(const boost::json::object&, std::string_view name);
std::string text_in(const boost::json::object&, std::string_view name);
/// Returns the member if it is a whole number, 0 or greater.
std::uint64_t number_in(const boost::json::object&, std::string_view name);
/// Returns the member if it is a position, such as `{"line": 3, "character": 7}`.
Position position_in(const boost::json::object&, std::string_view name);

} // namespace placedpar::editor
