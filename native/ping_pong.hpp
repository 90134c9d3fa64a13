#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <memory>

namespace placedpar {
class RankMail; // ranks/rank_mail.hpp
class Ranks;    // ranks/ranks.hpp
} // namespace placedpar

namespace placedpar::native {

/// Two processes that send a message there and back many times, to measure what messages between threads or ranks cost.
struct PingPong {
    std::size_t kernels = 2; ///< 1: both processes are on one thread; 2: on two threads
    long times = 1000;       ///< at least 1
    std::size_t bytes = 0;   ///< length of the message; both processes write to each of its cache lines
    Time pause{};            ///< time before each message in which no process has anything to do, so that threads fall
                             ///< asleep
};

/// Runs the two processes on threads of this computer. Returns the time for a message there and back, without the
/// pauses, in nanoseconds. The result is the median of batches of messages, because other programs can disturb some
/// batches.
double nanoseconds_there_and_back(const PingPong&);

/// Returns the time of a switch from one process to another on the same thread, in nanoseconds: the median of batches
/// of switches. REQUIRES: times >= 1.
double nanoseconds_of_switch(long times);

/// Measures the same times between two ranks, that is, copies of the program that mpirun started. Rank 0 measures, and
/// rank 1 takes part.
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

/// Returns by how many nanoseconds a short sleep of a thread is longer than requested. A rank sleeps in such pauses
/// while it has nothing to do.
double nanoseconds_of_oversleeping();

} // namespace placedpar::native
