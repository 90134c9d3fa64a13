#pragma once

#include <netdb.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace placedpar::iserver {

/// Is asked several times a second, and returns whether to stop.
using Interrupted = std::function<bool()>;

enum class Wait { ready, interrupted, too_long };

/// Waits until the descriptor can be read (POLLIN) or written (POLLOUT), at most for `patience` if that is given.
Wait wait_for(int descriptor, short events, const Interrupted&, std::optional<std::chrono::milliseconds> patience);

/// An address "HOST:PORT" of a board on a network.
struct NetworkAddress {
    std::string host, port;
};

/// Takes "tcp:HOST:PORT" apart. An address of IPv6 stands in brackets. Throws UserError if a part is missing.
NetworkAddress network_address(const std::string& name);

/// Returns the addresses that a name has. Throws UserError, which begins with `name`.
std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses_of(const std::string& name, const NetworkAddress&);

} // namespace placedpar::iserver
