#pragma once

#include "iserver/packet.hpp"
#include "iserver/streams.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace placedpar::iserver {

struct ServerOptions {
    std::filesystem::path host_folder = ""; ///< "": no file can be opened
    std::string command_line = "";          ///< the program's own arguments
    std::string whole_command_line = "";    ///< the command line with the server's own options
    /// The only environment variables that the program can read. INMOS's tools read IBOARDSIZE, IDEBUGSIZE and ISEARCH.
    std::map<std::string, std::string, std::less<>> environment = {};
    std::uint64_t write_limit_bytes = 64U << 20;
    std::chrono::sys_seconds date = std::chrono::sys_days(std::chrono::year(1991) / 1 / 1); ///< the date that the
                                                                                            ///< program sees at the
                                                                                            ///< start of the run
    std::optional<Bytes> core = std::nullopt; ///< contents of the transputer's memory before the boot, for debuggers
};

enum class RequestTag : std::uint8_t; // server.cpp

enum class ServerState {
    running,
    exited,         ///< the program has ended
    waits_for_input ///< the program waits for a key or a line, but the input has ended
};

struct Answer {
    Bytes reply;           ///< the reply as a packet; empty if the program waits for input that will never come
    ServerState state;     ///< if not `running`, the server takes no further requests
    std::int32_t exit = 0; ///< the program's exit status: 0 for success, 1 for failure, or its own number
};

/// The host of a transputer program: answers the requests of the iserver protocol, as INMOS's server does. The program
/// is not trusted: it reaches the files of one folder, the terminal, and nothing else of this computer. A request may
/// consist of any bytes.
///
/// Unlike INMOS's server, this server executes no commands, and its date is the date of the options plus the time since
/// the start. The server claims to be version 1.0, because from version 1.4 on a program may send packets of 1024
/// bytes.
class Server {
public:
    /// A program that polls the keyboard this number of times in a row, without another request, counts as waiting for
    /// a key. Without this rule, a program that polls after the end of the input would run for ever.
    static constexpr std::size_t most_polls = 100'000;
    /// A program that makes this number of requests for stream 0, the input, after its end counts as waiting for a
    /// line.
    static constexpr std::size_t most_requests_at_end = 1000;

    /// Throws UserError if the host's folder cannot be opened, or if a text of the options is too long for a reply.
    /// REQUIRES: the terminal outlives the server.
    Server(ServerOptions, Terminal&);
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Answers a request, which is a packet without its length. The time since the start is simulated time, or measured
    /// time for a real board. Returns no reply if an earlier answer's state was not `running`.
    Answer answer(ByteView request, std::chrono::microseconds since_start);
    /// Writes the end of the output to the terminal. Call this function when a run has ended, for any reason.
    void finish();
    /// Returns whether the program has polled for a key after the input had ended.
    bool was_out_of_keys() const { return was_out_of_keys_; }
    /// Returns whether output was lost because of the write limit.
    bool exceeded_write_limit() const { return quota_.exceeded(); }

private:
    Reply reply_to(RequestTag, RequestFields&);
    Reply reply_for_stream(RequestTag, RequestFields&);
    Reply open(RequestFields&);
    Reply key(std::optional<std::uint8_t>);
    Reply poll_key();
    Reply time() const;
    Reply core(RequestFields&) const;
    Reply exit(RequestFields&);

    ServerOptions options_;
    Terminal& terminal_;
    HostFolder folder_;
    WriteQuota quota_;
    VisibleText visible_;
    Streams streams_;
    ServerState state_ = ServerState::running;
    std::int32_t exit_ = 0;
    std::chrono::microseconds since_start_{};
    bool was_out_of_keys_ = false;
    std::size_t polls_ = 0;  ///< polls in a row after the last key
    std::size_t at_end_ = 0; ///< requests for stream 0 since it ended
};

} // namespace placedpar::iserver
