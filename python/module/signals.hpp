#pragma once

#include "explore/netlist_run.hpp"

namespace placedpar::python {

/// An interruption that Ctrl-C (SIGINT) and the end of Python request. Ctrl-C is also passed on to Python, which raises
/// KeyboardInterrupt as soon as it has the lock again. If Python ignores Ctrl-C, it is ignored here, too.
///
/// 1. Objects that heed Ctrl-C exist on Python's main thread only, and end in reverse order: a process may call a
/// sweep.
/// 2. An object begins and ends while its thread has the lock.
class InterruptedByKeyboard : public Interruption {
public:
    /// `heeds`: false on another thread, where Python ignores signals.
    explicit InterruptedByKeyboard(bool heeds);
    ~InterruptedByKeyboard();
    InterruptedByKeyboard(const InterruptedByKeyboard&) = delete;
    InterruptedByKeyboard& operator=(const InterruptedByKeyboard&) = delete;

    /// Requests the interruption that exists around this one, and so on outwards.
    void request_all() noexcept;

private:
    const bool heeds_;
    InterruptedByKeyboard* outer_ = nullptr; ///< another one that heeds Ctrl-C, or null
};

/// Requests all interruptions and waits until they have ended, but not longer than 10 s: Python's end ends the other
/// threads as soon as they ask for the lock, which a run does not survive. REQUIRES: the caller holds the lock.
void end_all_runs();

} // namespace placedpar::python
