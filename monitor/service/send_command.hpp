#pragma once

#include <cstdint>
#include <string>

namespace placedpar::monitor {

/// The address of a running monitor, and the token that it requires from clients.
struct ServicePlace {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;
    std::string unix_path;  ///< replaces address and port; empty: not used
    std::string token_file; ///< empty: no token
};

/// Sends one message, a JSON object, to the monitor and returns its answer, one line. Throws UserError if the monitor
/// cannot be reached, does not answer within 10 s, or answers with an error.
std::string ask_service(const ServicePlace& place, const std::string& message);

/// Throws UserError unless the line is an answer of a monitor and not an error. `name` says where the line is from.
void require_answer(const std::string& name, const std::string& line);

} // namespace placedpar::monitor
