#pragma once

#include <cstddef>
#include <cstdint>

namespace placedpar::monitor {

/// What the service tolerates; all ours.
struct ServiceLimits {
    std::size_t clients = 256; ///< that have said hello; a quarter as many more may be about to
    std::size_t machines = 1000;
    std::uint64_t known_samples = 1000; ///< that make a machine known: a name and a few samples cost nothing
    double known_s = 600;               ///< from the first of its samples to the one that makes it known
    std::size_t clients_per_peer = 128, machines_per_peer = 500; ///< of those; a peer: see Caller
    std::size_t takeovers_per_peer = 60;                         ///< of a machine's control, in a minute
    double newcomer_s = 600;            ///< a machine without a sample and a connection is forgotten
    std::uint64_t history = 5000;       ///< estimates, and alarms, of a machine that are kept
    std::size_t line_bytes = 64u << 10; ///< of one message
    std::size_t queue_bytes = 1u << 20; ///< waiting to be sent to one client
    double hello_s = 10;                ///< from the connection to the first hello, load or ping
    double line_s = 10;                 ///< from the first to the last byte of a line
    double idle_s = 300;                ///< without a line
    double stall_s = 10;                ///< without the client reading anything
    double closing_s = 1;               ///< for a client to read the last message
};

} // namespace placedpar::monitor
