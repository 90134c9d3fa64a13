#include "monitor/service/systemd.hpp"

#include <fmt/format.h>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace placedpar::monitor {

std::string tell_systemd(std::string_view state) {
    const char* path = std::getenv("NOTIFY_SOCKET");
    sockaddr_un to{};
    to.sun_family = AF_UNIX;
    if (!path)
        return "";
    auto failure = [&](const char* why) {
        return fmt::format("cannot send \"{}\" to systemd: NOTIFY_SOCKET is \"{:.200}\": {}", state, path, why);
    };
    if (path[0] != '/' && path[0] != '@')
        return failure("expected a path that begins with /, or an abstract name that begins with @");
    if (std::strlen(path) >= sizeof to.sun_path)
        return failure("the name is too long for a socket");
    std::memcpy(to.sun_path, path, std::strlen(path));
    if (path[0] == '@') // an abstract name, which is not in the file system
        to.sun_path[0] = '\0';
    int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0)
        return failure(std::strerror(errno));
    auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + std::strlen(path));
    bool told = ::sendto(socket, state.data(), state.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
                         reinterpret_cast<const sockaddr*>(&to), size) >= 0;
    int reason = errno;
    ::close(socket);
    return told ? "" : failure(std::strerror(reason));
}

} // namespace placedpar::monitor
