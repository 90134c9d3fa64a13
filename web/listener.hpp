#pragma once

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/steady_timer.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace placedpar::web {

/// The other end of a connection to a service: a browser or another program.
struct Caller {
    /// The party to which limits apply, such as the greatest number of connections. For TCP, the peer is the IPv4
    /// address, or the 64-bit network of the IPv6 address. All loopback addresses are the peer "loopback", since each
    /// local program can use millions of them. For a socket in the file system, the peer is the user, such as "user
    /// 1000".
    std::string peer;
    std::string name; ///< name in messages, including the port
    std::string here; ///< the local address at which the connection arrived
};

/// Accepts connections for a service, at a TCP port or at a socket in the file system.
class Listener {
public:
    using Socket = boost::asio::generic::stream_protocol::socket;
    using Acceptor = boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol>;

    /// Listens at a TCP port. `option` is the command-line option that sets the port, such as "--port", for messages.
    /// Throws UserError.
    static Listener at_port(boost::asio::io_context& io, const std::string& address, std::uint16_t port,
                            const std::string& option);
    /// Listens at a socket in the file system. Replaces an old socket if no program listens there any more. Only
    /// programs of this user and this group may connect. Throws UserError.
    static Listener at_path(boost::asio::io_context& io, const std::string& path);
    ~Listener();
    Listener(Listener&&) = default;
    Listener& operator=(Listener&&) = delete;

    /// Begins to accept connections and gives each to `welcome`. REQUIRES: the listener is not moved before it is
    /// closed and the event loop has run once more.
    void open(std::function<void(Socket, const Caller&)> welcome);
    /// Stops accepting connections and removes the socket from the file system.
    void close();

    std::uint16_t port() const { return port_; }

private:
    Listener(boost::asio::io_context& io, Acceptor acceptor) : acceptor_(std::move(acceptor)), retry_(io) {}
    void accept();
    void accept_later();

    Acceptor acceptor_;
    boost::asio::steady_timer retry_;
    std::function<void(Socket, const Caller&)> welcome_;
    std::uint16_t port_ = 0;
    std::string path_;
};

/// Converts an IPv4 address inside IPv6 to IPv4. Returns any other address unchanged.
boost::asio::ip::address plain_address(const boost::asio::ip::address& address);

/// Returns whether the text is an address that only this computer can reach.
bool is_loopback(const std::string& address);

/// Returns the address as a URL needs it: IPv6 in brackets.
std::string address_in_url(const std::string& address);

} // namespace placedpar::web
