#pragma once

#include "runtime/time.hpp"

#include <cstddef>

namespace placedpar::native {

/// Two processes that send a message there and back over and over.
struct PingPong {
    std::size_t threads = 2; ///< 1: both processes are on one kernel
    long times = 1000;       ///< at least 1
    std::size_t bytes = 0;   ///< length of the message; both processes write to each cache line of it
    Time pause{};            ///< time before each message, in which no process has anything to do
};

/// Runs it natively. Returns the time for a message there and back, without the pauses, in nanoseconds. It is the
/// median of batches of messages, since other programs on the computer can make some of them take much longer.
double nanoseconds_there_and_back(const PingPong&);

/// Returns the time of a switch from one process to another on a kernel, in nanoseconds: the median of batches of
/// switches. REQUIRES: times >= 1.
double nanoseconds_of_switch(long times);

} // namespace placedpar::native
