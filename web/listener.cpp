#include "web/listener.hpp"

#include "text/user_error.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <fmt/format.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <utility>

namespace placedpar::web {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::local::stream_protocol;
using boost::system::error_code;

namespace {

std::string peer_at(const asio::ip::address& address) {
    if (address.is_loopback())
        return "loopback";
    if (!address.is_v6())
        return address.to_string();
    auto bytes = address.to_v6().to_bytes();
    std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
    return asio::ip::address_v6(bytes).to_string();
}

tcp::endpoint tcp_end(const asio::generic::stream_protocol::endpoint& end) {
    tcp::endpoint found;
    std::memcpy(found.data(), end.data(), std::min(end.size(), found.capacity()));
    return found;
}

Caller caller_of(Listener::Socket& socket) {
    error_code error;
    auto end = socket.remote_endpoint(error);
    if (error)
        return {"unknown", "unknown", ""};
    if (end.protocol().family() == AF_UNIX) {
        ucred who{};
        socklen_t size = sizeof who;
        ::getsockopt(socket.native_handle(), SOL_SOCKET, SO_PEERCRED, &who, &size);
        return {fmt::format("user {}", who.uid), fmt::format("process {} of user {}", who.pid, who.uid), ""};
    }
    tcp::endpoint tcp = tcp_end(end);
    asio::ip::address there = plain_address(tcp.address()), here;
    if (auto local = socket.local_endpoint(error); !error)
        here = plain_address(tcp_end(local).address());
    return {peer_at(there), fmt::format("{} port {}", there.to_string(), tcp.port()), here.to_string()};
}

/// Makes the path free for a new socket. Removes an old socket if no program listens at this socket any more. Throws
/// UserError if anything else has this path.
void clear_path(const std::string& path) {
    namespace fs = std::filesystem;
    if (!fs::exists(fs::symlink_status(path)))
        return;
    if (!fs::is_socket(fs::symlink_status(path)))
        throw UserError(fmt::format("--unix {}: this file exists and is not a socket; choose another path", path));
    asio::io_context io;
    stream_protocol::socket socket(io);
    error_code error;
    socket.connect(stream_protocol::endpoint(path), error);
    if (error != asio::error::connection_refused)
        throw UserError(fmt::format("--unix {}: another program already listens on this socket; choose another "
                                    "path",
                                    path));
    fs::remove(path);
}

} // namespace

asio::ip::address plain_address(const asio::ip::address& address) {
    if (!address.is_v6() || !address.to_v6().is_v4_mapped())
        return address;
    return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6());
}

bool is_loopback(const std::string& address) {
    error_code error;
    asio::ip::address parsed = asio::ip::make_address(address, error);
    return !error && plain_address(parsed).is_loopback();
}

std::string address_in_url(const std::string& address) {
    return address.find(':') == address.npos ? address : fmt::format("[{}]", address);
}

Listener Listener::at_port(asio::io_context& io, const std::string& address, std::uint16_t port,
                           const std::string& option) {
    error_code error;
    asio::ip::address parsed = asio::ip::make_address(address, error);
    if (error)
        throw UserError(fmt::format("--address {}: expected an address such as 127.0.0.1 or ::1", address));
    tcp::endpoint end(parsed, port);
    Acceptor acceptor(io);
    acceptor.open(end.protocol(), error);
    if (!error)
        acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error)
        acceptor.bind(end, error);
    if (!error)
        acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
        throw UserError(fmt::format("cannot listen on {} port {}: {}; choose another {}, or 0 for any free port",
                                    address, port, error.message(), option));
    Listener door(io, std::move(acceptor));
    door.port_ = tcp_end(door.acceptor_.local_endpoint()).port();
    return door;
}

Listener Listener::at_path(asio::io_context& io, const std::string& path) {
    constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
    if (path.size() > longest)
        throw UserError(
            fmt::format("--unix {}: the path has more than {} bytes; choose a shorter path", path, longest));
    clear_path(path);
    stream_protocol::endpoint end(path);
    Acceptor acceptor(io);
    error_code error;
    acceptor.open(end.protocol(), error);
    mode_t former = ::umask(0117); // read and write, for user and group
    if (!error)
        acceptor.bind(end, error);
    ::umask(former);
    if (!error)
        acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
        throw UserError(fmt::format("--unix {}: {}; choose another path", path, error.message()));
    Listener door(io, std::move(acceptor));
    door.path_ = path;
    return door;
}

Listener::~Listener() { close(); }

void Listener::open(std::function<void(Socket, const Caller&)> welcome) {
    welcome_ = std::move(welcome);
    accept();
}

void Listener::accept() {
    acceptor_.async_accept([this](const error_code& error, Socket socket) {
        if (!acceptor_.is_open())
            return;
        if (!error) {
            Caller caller = caller_of(socket);
            welcome_(std::move(socket), caller);
            accept();
            return;
        }
        accept_later(); // probably too many files are open; retry later, when a client has left
    });
}

void Listener::accept_later() {
    retry_.expires_after(std::chrono::milliseconds(100));
    retry_.async_wait([this](const error_code&) {
        if (acceptor_.is_open())
            accept();
    });
}

void Listener::close() {
    if (!acceptor_.is_open())
        return;
    error_code ignored;
    acceptor_.close(ignored);
    retry_.cancel();
    if (!path_.empty())
        ::unlink(path_.c_str());
}

} // namespace placedpar::web
