#pragma once

#include <cstdint>
#include <string>

namespace placedpar::monitor {

/// Where a running service is, and what it wants to hear first.
struct ServicePlace {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;
    std::string unix_path;  ///< in place of address and port; empty: none
    std::string token_file; ///< empty: none
};

/// Says one message to it, a JSON object, and gives the answer, a line. Throws UserError when it cannot be reached,
/// says nothing for ten seconds, or answers that something is wrong.
std::string ask_service(const ServicePlace& place, const std::string& message);

/// Throws UserError unless a line is an answer of a monitor, and says that nothing is wrong. `name` is where it is
/// from.
void require_answer(const std::string& name, const std::string& line);

} // namespace placedpar::monitor
