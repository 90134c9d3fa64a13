#pragma once

#include <cstddef>
#include <cstdint>

namespace placedpar::monitor {

/// The limits of the service, so that no client can use up its memory or time. All values are this project's choice.
struct ServiceLimits {
    std::size_t clients = 256; ///< largest number of clients that have sent hello, their first message; `clients` / 4
                               ///< others may be connected that have not
    std::size_t machines = 1000;
    std::uint64_t known_samples = 1000; ///< samples after which a machine can become known and keep its place; a few
                                        ///< samples would cost an attacker nothing
    double known_s = 600; ///< least time from a machine's first sample to the sample that makes the machine known
    std::size_t clients_per_peer = 128,
                machines_per_peer = 500; ///< shares of `clients` and `machines` that one peer may use; a peer is the
                                         ///< computer or user from which a client comes
    std::size_t takeovers_per_peer = 60; ///< how often per minute a peer may take over the control of machines
    double newcomer_s = 600;             ///< time after which a machine without samples and connections is forgotten
    std::uint64_t history = 5000;        ///< number of estimates, and number of alarms, that are kept per machine
    std::size_t line_bytes = 64u << 10;  ///< longest message
    std::size_t queue_bytes = 1u << 20;  ///< largest number of bytes that wait to be sent to one client
    double hello_s = 10;  ///< longest time from the connection to the first message of type hello, load or ping
    double line_s = 10;   ///< longest time from the first to the last byte of a line
    double idle_s = 300;  ///< longest time in which a client sends no line
    double stall_s = 10;  ///< longest time in which a client reads nothing
    double closing_s = 1; ///< time that a client has to read the last line before its connection is closed
};

} // namespace placedpar::monitor
