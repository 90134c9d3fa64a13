#pragma once

#include <atomic>

namespace placedpar {

/// What can be so of a run, but seldom is, and what a kernel would have to ask about at each of its steps: one question
/// does for all of them.
class Circumstances {
public:
    enum Circumstance : unsigned {
        nobody_left = 1,  ///< every process of the program has ended
        failed = 2,       ///< a process or an observer has thrown
        at_the_limit = 4, ///< the next event lies behind the time limit
        interrupted = 8,  ///< from outside
        unwinding = 16,   ///< the run is over, and its processes are unwound
        histories = 32,   ///< a process keeps one
        shuffled = 64,    ///< the ready queue is
        unguarded = 128   ///< some stacks are not
    };

    /// But for histories, which nobody asks about who does not keep one.
    bool any() const { return any_of(~unsigned{histories}); }
    /// One of these, which are a sum.
    bool any_of(unsigned these) const { return (which_.load(std::memory_order_relaxed) & these) != 0; }
    /// Also in a signal handler.
    void set(Circumstance which) { which_.fetch_or(which, std::memory_order_relaxed); }
    void clear(Circumstance which) { which_.fetch_and(~unsigned{which}, std::memory_order_relaxed); }

private:
    static_assert(std::atomic<unsigned>::is_always_lock_free);
    std::atomic<unsigned> which_{0};
};

} // namespace placedpar
