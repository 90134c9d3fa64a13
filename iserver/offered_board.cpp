#include "iserver/offered_board.hpp"

#include "iserver/descriptors.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

namespace placedpar::iserver {

namespace {

[[noreturn]] void fail_at(const std::string& where) {
    throw UserError(fmt::format("{}: {}", where, std::generic_category().message(errno)));
}

/// Returns the address at which a socket listens, as "HOST:PORT".
std::string address_of(const OpenFile& socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    std::array<char, NI_MAXHOST> host{};
    std::array<char, NI_MAXSERV> port{};
    ::getsockname(socket.descriptor(), reinterpret_cast<sockaddr*>(&address), &size);
    ::getnameinfo(reinterpret_cast<sockaddr*>(&address), size, host.data(), host.size(), port.data(), port.size(),
                  NI_NUMERICHOST | NI_NUMERICSERV);
    return address.ss_family == AF_INET6 ? fmt::format("[{}]:{}", host.data(), port.data())
                                         : fmt::format("{}:{}", host.data(), port.data());
}

} // namespace

OfferedBoard::OfferedBoard(const std::string& where, Interrupted interrupted) : interrupted_(std::move(interrupted)) {
    if (where == "pty")
        open_terminal();
    else if (where.starts_with("tcp:"))
        listen(where);
    else
        throw UserError(fmt::format("{}: a link is offered at \"pty\", \"tcp:PORT\" or \"tcp:ADDRESS:PORT\"", where));
}

void OfferedBoard::listen(const std::string& where) {
    const bool only_port = where.find(':', 4) == where.npos;
    const auto addresses = addresses_of(where, network_address(only_port ? "tcp:127.0.0.1:" + where.substr(4) : where));
    const addrinfo& address = *addresses;
    listener_ = OpenFile(::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    const int again = 1;
    ::setsockopt(listener_.descriptor(), SOL_SOCKET, SO_REUSEADDR, &again, sizeof again);
    if (!listener_ || ::bind(listener_.descriptor(), address.ai_addr, address.ai_addrlen) != 0 ||
        ::listen(listener_.descriptor(), 1) != 0)
        fail_at(where);
    name_ = "tcp:" + address_of(listener_);
}

/// Opens a pseudo terminal. Also opens and closes its other end, so that the system from then on reports whether a
/// program has the other end open.
void OfferedBoard::open_terminal() {
    link_ = OpenFile(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 64> name{};
    if (!link_ || ::grantpt(link_.descriptor()) != 0 || ::unlockpt(link_.descriptor()) != 0 ||
        ::ptsname_r(link_.descriptor(), name.data(), name.size()) != 0)
        fail_at("pty");
    name_ = name.data();
    const OpenFile other(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios settings;
    if (!other || ::tcgetattr(other.descriptor(), &settings) != 0)
        fail_at(name_);
    ::cfmakeraw(&settings);
    ::tcsetattr(other.descriptor(), TCSANOW, &settings);
}

bool OfferedBoard::wait_for_program() {
    if (listener_) {
        if (wait_for(listener_.descriptor(), POLLIN, interrupted_, std::nullopt) == Wait::interrupted)
            return false;
        link_ = OpenFile(::accept4(listener_.descriptor(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
        const int at_once = 1; // sends each request at once, since its sender waits for the reply
        ::setsockopt(link_.descriptor(), IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
        return true;
    }
    pollfd end{.fd = link_.descriptor(), .events = POLLIN, .revents = 0};
    while (::poll(&end, 1, 0) > 0 && (end.revents & POLLHUP) != 0) {
        if (interrupted_())
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

std::optional<Bytes> OfferedBoard::read(bool waits) {
    Bytes bytes(65536);
    for (;;) {
        const ssize_t count = ::read(link_.descriptor(), bytes.data(), bytes.size());
        if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR))
            return std::nullopt;
        if (count > 0 || !waits) {
            bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
            return bytes;
        }
        if (wait_for(link_.descriptor(), POLLIN, interrupted_, std::nullopt) == Wait::interrupted)
            return std::nullopt;
    }
}

bool OfferedBoard::write(ByteView bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(link_.descriptor(), bytes.data(), bytes.size());
        if (count < 0 && errno != EAGAIN && errno != EINTR)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (count < 0 && wait_for(link_.descriptor(), POLLOUT, interrupted_, std::nullopt) == Wait::interrupted)
            return false;
    }
    return true;
}

} // namespace placedpar::iserver
