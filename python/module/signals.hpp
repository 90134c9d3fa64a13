#pragma once

#include "explore/netlist_run.hpp"

namespace placedpar::python {

/// An interruption that is requested by Ctrl-C (SIGINT), and when Python exits. Ctrl-C is also passed on to Python,
/// which raises KeyboardInterrupt as soon as it has the lock again. If Python ignores Ctrl-C, this class ignores it,
/// too.
///
/// 1. Objects that react to Ctrl-C exist on Python's main thread only. They may be nested: a process in Python may
///    itself call sweep(). They end in reverse order.
/// 2. An object is made and destroyed while its thread holds Python's global lock.
class InterruptedByKeyboard : public Interruption {
public:
    /// Returns whether the caller runs on Python's main thread.
    static bool is_main_thread();
    /// `heeds`: true if the object reacts to Ctrl-C; must be false outside Python's main thread.
    explicit InterruptedByKeyboard(bool heeds = is_main_thread());
    ~InterruptedByKeyboard();
    InterruptedByKeyboard(const InterruptedByKeyboard&) = delete;
    InterruptedByKeyboard& operator=(const InterruptedByKeyboard&) = delete;

    /// Requests this interruption and all enclosing interruptions.
    void request_all() noexcept;

private:
    const bool heeds_;
    InterruptedByKeyboard* outer_ = nullptr; ///< the enclosing object that reacts to Ctrl-C; null if there is none
};

/// Requests all interruptions and waits, at most 10 s, until their runs have ended. When Python exits, it ends each
/// thread that asks for Python's global lock; a run that still went on would crash. REQUIRES: the caller holds this
/// lock.
void end_all_runs();

} // namespace placedpar::python
