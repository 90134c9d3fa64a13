#include "monitor/service/systemd.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace placedpar::monitor {

void tell_systemd(std::string_view state) {
    const char* path = std::getenv("NOTIFY_SOCKET");
    sockaddr_un to{};
    to.sun_family = AF_UNIX;
    if (!path || std::strlen(path) >= sizeof to.sun_path || (path[0] != '/' && path[0] != '@'))
        return;
    std::memcpy(to.sun_path, path, std::strlen(path));
    if (path[0] == '@') // it is abstract: in no file system
        to.sun_path[0] = '\0';
    int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0)
        return;
    auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + std::strlen(path));
    (void)::sendto(socket, state.data(), state.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
                   reinterpret_cast<const sockaddr*>(&to), size);
    ::close(socket);
}

} // namespace placedpar::monitor
