#pragma once

#include "explore/netlist_run.hpp"

namespace placedpar::python {

/// An interruption ends a run early. Ctrl-C (SIGINT) and the exit of Python request this one. Python gets the Ctrl-C,
/// too, and raises KeyboardInterrupt as soon as it has its global lock again. If Python ignores Ctrl-C, this class
/// ignores it, too.
///
/// 1. Objects that react to Ctrl-C exist on Python's main thread only. They may be nested: a process in Python may
///    itself call sweep(). They end in reverse order.
/// 2. An object is made and destroyed while its thread holds Python's global lock.
class InterruptedByKeyboard : public Interruption {
public:
    /// Returns whether the caller runs on Python's main thread.
    static bool is_main_thread();
    /// `heeds`: whether the object reacts to Ctrl-C; must be false outside Python's main thread.
    explicit InterruptedByKeyboard(bool heeds = is_main_thread());
    ~InterruptedByKeyboard();
    InterruptedByKeyboard(const InterruptedByKeyboard&) = delete;
    InterruptedByKeyboard& operator=(const InterruptedByKeyboard&) = delete;

    /// Requests this interruption and the interruptions of all enclosing runs.
    void request_all() noexcept;

private:
    const bool heeds_;
    InterruptedByKeyboard* outer_ = nullptr; ///< the enclosing object that reacts to Ctrl-C; null if there is none
};

/// Requests all interruptions and waits, at most 10 s, until their runs have ended. Call this function when Python
/// exits. Python then ends each thread that asks for Python's global lock, and a run that continued would crash.
/// REQUIRES: the caller holds this lock.
void end_all_runs();

} // namespace placedpar::python
