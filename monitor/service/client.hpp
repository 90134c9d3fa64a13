#pragma once

#include "monitor/protocol/message.hpp"
#include "web/listener.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace placedpar::monitor {

/// A program that is connected to the service. The Dispatcher, which answers messages, uses this class and so needs no
/// sockets.
class Client {
public:
    virtual ~Client() = default;
    virtual void send(std::string_view line) = 0;
    /// Sends the waiting output, then closes the connection.
    virtual void finish() = 0;
    /// Ends the time limit for the first message. Call this function when the client has sent hello.
    virtual void greeted() = 0;
    /// Returns whether finish() has been called or the connection is closed.
    virtual bool finishing() const = 0;
    /// Returns the number of lines received from the client, including the present one.
    virtual std::size_t lines() const = 0;
    virtual std::size_t queued_bytes() const = 0;
    /// Adds `bytes`, which may be negative, to the bytes that wait for the disk and count as queued.
    virtual void hold(std::ptrdiff_t bytes) = 0;

    web::Caller caller;
    bool trusted = false;                            ///< the client has sent the token, or none is required
    std::optional<Hello> hello;                      ///< the hello that the client sent
    std::chrono::steady_clock::time_point last_load; ///< when the last load report was sent to the client
    bool leaving = false;                            ///< the client is about to be closed and sends no more lines
    std::chrono::steady_clock::time_point heard;     ///< when the client's last line arrived
    bool has_samples = false;                        ///< at least one of the client's samples was accepted
    /// Whether the client serves a machine that has sent many samples. No new client then takes this client's place.
    bool keeps_place = false;
    bool told_kept = true; ///< value of `kept` in the last kept_line() sent to the client
};

} // namespace placedpar::monitor
