#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <memory>

namespace placedpar {
class RankMail; // ranks/rank_mail.hpp
class Ranks;    // ranks/ranks.hpp
} // namespace placedpar

namespace placedpar::native {

/// Two processes that send a message back and forth many times.
struct PingPong {
    std::size_t kernels = 2; ///< 1: both processes are on one kernel
    long times = 1000;       ///< at least 1
    std::size_t bytes = 0;   ///< length of the message; both processes write to each cache line of it
    Time pause{};            ///< time before each message, in which no process has anything to do
};

/// Runs the two processes natively on threads. Returns the time for a message there and back, without the pauses, in
/// nanoseconds. The result is the median of batches of messages, because other programs on the computer can make some
/// batches take much longer.
double nanoseconds_there_and_back(const PingPong&);

/// Returns the time of a switch from one process to another on a kernel, in nanoseconds: the median of batches of
/// switches. REQUIRES: times >= 1.
double nanoseconds_of_switch(long times);

/// Measures the time of a message there and back between rank 0 and rank 1 of mpirun. Rank 0 measures, and rank 1 takes
/// part.
///
/// REQUIRES: there are two ranks. Rank 1 calls play_with_rank_zero() when rank 0 makes an object of this class; the
/// call returns when the object is destroyed.
class RankMatches {
public:
    explicit RankMatches(Ranks&);
    ~RankMatches();
    RankMatches(const RankMatches&) = delete;
    RankMatches& operator=(const RankMatches&) = delete;

    double nanoseconds_there_and_back(const PingPong&);
    double nanoseconds_of_switch(long times);

private:
    void announce(const PingPong&);

    Ranks& ranks_;
    std::unique_ptr<RankMail> mail_;
};
void play_with_rank_zero(Ranks&);

/// Returns by how many nanoseconds a short pause of a rank (pause_after) is longer than requested.
double nanoseconds_of_oversleeping();

} // namespace placedpar::native
