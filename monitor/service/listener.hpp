#pragma once

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/steady_timer.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace placedpar::monitor {

/// Who is at the other end of a connection.
struct Caller {
    /// Whom limits are for: an address, of IPv6 the network of 64 bits; "loopback", whatever the address, since every
    /// program of this computer has millions of them; "user 1000" at a socket in the file system.
    std::string peer;
    std::string name; ///< for people: with the port
    std::string here; ///< the address by which the connection came in
};

/// A place where connections come in: a port, or a socket in the file system.
class Listener {
public:
    using Socket = boost::asio::generic::stream_protocol::socket;
    using Acceptor = boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol>;

    /// Throws UserError. `option` is what it is called on the command line: "--port".
    static Listener at_port(boost::asio::io_context& io, const std::string& address, std::uint16_t port,
                            const std::string& option);
    /// Takes the place of a socket where nobody listens any more. Only this user and group may connect.
    static Listener at_path(boost::asio::io_context& io, const std::string& path);
    ~Listener();
    Listener(Listener&&) = default;
    Listener& operator=(Listener&&) = delete;

    /// From now on; `welcome` is given each connection. REQUIRES: the door stays where it is until it is closed and the
    /// loop has turned.
    void open(std::function<void(Socket, const Caller&)> welcome);
    /// Removes the socket from the file system, too.
    void close();

    std::uint16_t port() const { return port_; }

private:
    Listener(boost::asio::io_context& io, Acceptor acceptor) : acceptor_(std::move(acceptor)), retry_(io) {}
    void accept();

    Acceptor acceptor_;
    boost::asio::steady_timer retry_;
    std::function<void(Socket, const Caller&)> welcome_;
    std::uint16_t port_ = 0;
    std::string path_;
};

/// One of IPv4 within IPv6, as IPv4.
boost::asio::ip::address plain_address(const boost::asio::ip::address& address);

/// Does this address lead to this computer only? False if it is not an address.
bool is_loopback(const std::string& address);

} // namespace placedpar::monitor
