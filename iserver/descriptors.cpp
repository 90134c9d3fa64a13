#include "iserver/descriptors.hpp"

#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>

namespace placedpar::iserver {

namespace {

constexpr std::chrono::milliseconds look_for_interruption{100};

} // namespace

Wait wait_for(int descriptor, short events, const Interrupted& interrupted,
              std::optional<std::chrono::milliseconds> patience) {
    const auto start = std::chrono::steady_clock::now();
    pollfd end{.fd = descriptor, .events = events, .revents = 0};
    for (;;) {
        if (interrupted())
            return Wait::interrupted;
        if (::poll(&end, 1, static_cast<int>(look_for_interruption.count())) > 0)
            return Wait::ready;
        if (patience && std::chrono::steady_clock::now() - start > *patience)
            return Wait::too_long;
    }
}

NetworkAddress network_address(const std::string& name) {
    const std::size_t colon = name.rfind(':');
    std::string host = name.substr(4, std::max<std::size_t>(colon, 4) - 4);
    if (host.starts_with('[') && host.ends_with(']'))
        host = host.substr(1, host.size() - 2);
    if (host.empty() || colon + 1 == name.size())
        throw UserError(fmt::format("{}: a board on a network is written \"tcp:HOST:PORT\"", name));
    const std::string port = name.substr(colon + 1);
    const bool is_number = port.find_first_not_of("-0123456789") == port.npos;
    if (const auto number = parse_number<std::uint16_t>(port); is_number && !number)
        throw UserError(fmt::format("{}: the port is {}, expected 0 to 65535", name, port));
    return {host, port};
}

std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses_of(const std::string& name, const NetworkAddress& address) {
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (const int error = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &wanted, &found); error != 0)
        throw UserError(fmt::format("{}: {}", name, ::gai_strerror(error)));
    return {found, ::freeaddrinfo};
}

} // namespace placedpar::iserver
