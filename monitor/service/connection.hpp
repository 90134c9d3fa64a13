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

/// One client's connection: lines come in, lines go out, both bounded.
///
/// 1. Bytes are read only while no whole line is waiting and little is waiting to be sent or held: TCP holds a flood
/// back, and
///    memory stays below line_bytes + queue_bytes and one read.
/// 2. One line is handed on per turn of the event loop: no client has to wait for another's flood.
/// 3. All functions are called from the loop's one thread.
class Connection : public std::enable_shared_from_this<Connection> {
public:
    using Socket = boost::asio::generic::stream_protocol::socket;
    using Clock = std::chrono::steady_clock;

    struct Handlers {
        /// A line without its newline. May send and finish.
        std::function<void(Connection&, std::string_view)> line;
        /// Puts why the connection will be closed into the protocol's words.
        std::function<std::string(const std::string& wrong, const std::string& right)> refusal;
        /// No handler is called any more.
        std::function<void(Connection&)> closed;
    };

    Connection(Socket socket, const ServiceLimits& limits, Handlers handlers);

    void start();
    /// A line with its newline. A client that lets more than queue_bytes pile up is told so and closed.
    void send(std::string_view line);
    /// Sends what is waiting and closes; what still comes in is thrown away.
    void finish();
    /// Closes the connection if something has taken too long. To be called a few times a second.
    void tick(Clock::time_point now);
    /// So many more, or fewer, bytes count as queued: they wait elsewhere.
    void hold(std::ptrdiff_t bytes);
    /// It has said what it is: the limit of hello_s is over.
    void greeted() { greeted_ = true; }
    /// At once.
    void close();

    /// It takes no more lines, and sends no more.
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
    std::string input_;        ///< not yet handed on
    std::size_t searched_ = 0; ///< of input_, without a newline
    std::string waiting_, writing_;
    std::size_t written_ = 0; ///< of writing_
    std::size_t lines_ = 0;
    std::size_t held_ = 0;
    bool greeted_ = false;
    bool reading_ = false;
    bool held_back_ = false; ///< until its client reads
    bool ended_ = false;     ///< the client sends no more
    bool finishing_ = false;
    bool closed_ = false;
    Clock::time_point opened_, last_line_, line_begun_, last_written_, finishing_since_;
};

} // namespace placedpar::monitor
