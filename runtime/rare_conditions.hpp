#pragma once

#include <atomic>

namespace placedpar {

/// Conditions that are seldom true of a run. They share one word, so that the kernel can test all of them at once in
/// each of its steps.
class RareConditions {
public:
    enum Circumstance : unsigned {
        no_process_left = 1, ///< every process of the program has ended
        failed = 2,          ///< a process or an observer has thrown
        at_the_limit = 4,    ///< the next event is beyond the time limit
        interrupted = 8,     ///< the run was interrupted from outside
        unwinding = 16,      ///< the run is over, and its processes are unwound
        histories = 32,      ///< processes keep histories, that is, logs of their actions (runtime/replay_log.hpp)
        shuffled = 64,       ///< ready processes run in a random order
        unguarded = 128,     ///< some stacks have no guard page, which would detect an overflow
        native = 256         ///< the run uses the wall clock, and other kernels send messages
    };

    /// Returns whether any condition except `histories` holds. The condition `histories` concerns only the operations
    /// of processes.
    bool any() const { return any_of(~unsigned{histories}); }
    /// Returns whether any of the conditions in the set `these` holds.
    bool any_of(unsigned these) const { return (which_.load(std::memory_order_relaxed) & these) != 0; }
    /// Sets a condition. May be called in a signal handler.
    void set(Circumstance which) { which_.fetch_or(which, std::memory_order_relaxed); }
    void clear(Circumstance which) { which_.fetch_and(~unsigned{which}, std::memory_order_relaxed); }

private:
    static_assert(std::atomic<unsigned>::is_always_lock_free);
    std::atomic<unsigned> which_{0};
};

} // namespace placedpar
