#pragma once

#include <netdb.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace placedpar::iserver {

/// A function that returns whether to stop waiting. It is called several times a second.
using Interrupted = std::function<bool()>;

enum class Wait { ready, interrupted, too_long };

/// Waits until the descriptor can be read (POLLIN) or written (POLLOUT), at most for the time `patience` if it is
/// given.
Wait wait_for(int descriptor, short events, const Interrupted&, std::optional<std::chrono::milliseconds> patience);

/// The address of a transputer board on a network.
struct NetworkAddress {
    std::string host, port;
};

/// Splits "tcp:HOST:PORT" into host and port. An IPv6 address is in brackets. Throws UserError if a part is missing, or
/// if the port is a number outside the range of ports.
NetworkAddress network_address(const std::string& name);

/// Returns the addresses of the host and the port. If they cannot be found, throws a UserError whose message begins
/// with `name`.
std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses_of(const std::string& name, const NetworkAddress&);

} // namespace placedpar::iserver
