#pragma once

#include "monitor/service/limits.hpp"

#include <boost/asio/generic/stream_protocol.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// Reads lines from one client of the service, and writes lines to it. In both directions, the number of waiting bytes
/// is limited.
///
/// 1. Bytes are read only while no whole line waits and little output waits. TCP therefore slows down a client that
///    sends too much. The memory used stays below `line_bytes` + `queue_bytes` + the size of one read.
/// 2. Each turn of the event loop handles one line per connection, so that a client that sends many lines does not
///    delay the others.
/// 3. All functions are called from the loop's only thread.
class Connection : public std::enable_shared_from_this<Connection> {
public:
    using Socket = boost::asio::generic::stream_protocol::socket;
    using Clock = std::chrono::steady_clock;

    struct Handlers {
        /// Receives a line without its newline. This function may call send() and finish().
        std::function<void(Connection&, std::string_view)> line;
        /// Returns the protocol's error line for the reason why the connection will be closed.
        std::function<std::string(const std::string& wrong, const std::string& right)> refusal;
        /// Is called when the connection has closed. Afterwards no handler is called.
        std::function<void(Connection&)> closed;
    };

    Connection(Socket socket, const ServiceLimits& limits, Handlers handlers);

    void start();
    /// Sends a line, which includes its newline. A client with more than `queue_bytes` waiting receives an error, and
    /// its connection is closed.
    void send(std::string_view line);
    /// Sends the waiting output, then closes the connection. Input that still arrives is discarded.
    void finish();
    /// Closes the connection if a time limit has passed. Call this function a few times a second.
    void tick(Clock::time_point now);
    /// Adds `bytes`, which may be negative, to the bytes that wait for the disk and count as waiting output.
    void hold(std::ptrdiff_t bytes);
    /// Ends the time limit for the client's first message.
    void greeted() { greeted_ = true; }
    /// Closes the connection immediately.
    void close();

    /// Returns whether the connection neither accepts nor sends further lines.
    bool finishing() const { return finishing_ || closed_; }
    std::size_t lines() const { return lines_; }
    std::size_t queued_bytes() const { return waiting_.size() + writing_.size() + held_; }

private:
    void read();
    void received(const boost::system::error_code& error, std::size_t count);
    void next_line();
    void hand_on(std::size_t end);
    void write();
    void sent(const boost::system::error_code& error, std::size_t count);
    void refuse(const std::string& wrong, const std::string& right);
    void go_on_finishing();

    Socket socket_;
    const ServiceLimits& limits_;
    Handlers handlers_;
    std::array<char, 16384> chunk_;
    std::string input_;        ///< bytes received and not yet handled
    std::size_t searched_ = 0; ///< number of bytes of input_ known to have no newline
    std::string waiting_, writing_;
    std::size_t written_ = 0; ///< bytes of writing_ already written
    std::size_t lines_ = 0;
    std::size_t held_ = 0;
    bool greeted_ = false;
    bool reading_ = false;
    bool held_back_ = false; ///< reading pauses until the client has read enough of the output
    bool ended_ = false;     ///< the client has ended its stream
    bool finishing_ = false;
    bool closed_ = false;
    Clock::time_point opened_, last_line_, line_begun_, last_written_, finishing_since_;
};

} // namespace placedpar::monitor
