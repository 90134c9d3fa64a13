#pragma once

#include "explore/netlist_run.hpp"

namespace placedpar::python {

/// While an object exists, Ctrl-C (SIGINT) requests the interruption and is passed on to Python, which raises
/// KeyboardInterrupt as soon as it has the lock again. Only one object may exist at a time, on Python's main thread.
class InterruptedByKeyboard : public Interruption {
public:
    /// `heeds`: false on another thread, where Python ignores signals; nothing happens then.
    explicit InterruptedByKeyboard(bool heeds);
    ~InterruptedByKeyboard();
    InterruptedByKeyboard(const InterruptedByKeyboard&) = delete;
    InterruptedByKeyboard& operator=(const InterruptedByKeyboard&) = delete;

private:
    const bool heeds_;
};

} // namespace placedpar::python
