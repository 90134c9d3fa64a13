#pragma once

#include "iserver/descriptors.hpp"
#include "iserver/server.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::iserver {

/// A request of a transputer program to its host, and the answer.
struct Exchange {
    Bytes request; ///< the request without its length field
    Answer answer;
};

/// The result of a run on a real transputer board, with measured times.
struct BoardRun {
    /// When the noted exchanges have this number of bytes, no more are noted.
    static constexpr std::size_t most_noted_bytes = 64 << 20;

    ServerState state = ServerState::running; ///< `running` if the run was interrupted
    std::int32_t exit = 0;                    ///< the program's exit status
    std::size_t requests = 0;                 ///< the number of requests that were served
    std::chrono::microseconds boot_time{};    ///< time until the last byte of the program was sent
    std::chrono::microseconds run_time{};     ///< time from the end of the boot to the end of the program
    std::vector<Exchange> exchanges = {};     ///< the first requests, usually all
};

/// Connects to a transputer board. The name "tcp:HOST:PORT" is a link adapter on a network; any other name is a
/// character device. A serial line or pseudo terminal is set to pass all bytes unchanged. If this fails, throws
/// UserError with the name and the reason. The result has no file if the attempt was interrupted.
OpenFile connect_board(const std::string& name, const Interrupted&);

/// Sends a bootable program to a board and serves its requests until the program ends. Throws UserError if the board
/// takes no bytes for `patience`, stops within a request, sends a wrong request or closes the connection. The error
/// message begins with `name`. REQUIRES: the user has reset the board, so that it waits to be booted; SIGPIPE is
/// ignored.
BoardRun serve_board(std::string_view program, const OpenFile& board, const std::string& name, Server&,
                     const Interrupted&, std::chrono::milliseconds patience = std::chrono::seconds(10));

} // namespace placedpar::iserver
