#pragma once

#include "monitor/protocol/message.hpp"
#include "monitor/service/listener.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace placedpar::monitor {

/// A program that is connected, as the dispatcher sees it: without its socket.
class Client {
public:
    virtual ~Client() = default;
    virtual void send(std::string_view line) = 0;
    /// Sends what is waiting and closes.
    virtual void finish() = 0;
    /// It has said what it is: the time limit on that is over.
    virtual void greeted() = 0;
    virtual bool finishing() const = 0;
    /// Lines received from it, the present one included.
    virtual std::size_t lines() const = 0;
    virtual std::size_t queued_bytes() const = 0;
    /// So many more, or fewer, of its bytes wait for the disk: they count as queued.
    virtual void hold(std::ptrdiff_t bytes) = 0;

    Caller caller;
    bool trusted = false;                            ///< it knows the token, or there is none
    std::optional<Hello> hello;                      ///< the one it said
    std::chrono::steady_clock::time_point last_load; ///< when it was sent the load
    bool leaving = false;                            ///< it is about to be closed: takes no more lines
    std::chrono::steady_clock::time_point heard;     ///< when its last line came
    bool has_samples = false;                        ///< some of it were accepted
    bool keeps_place = false;                        ///< for a machine that is known: no newcomer takes its place
    bool told_kept = true;                           ///< the last it was told of whether what is known is kept
};

} // namespace placedpar::monitor
