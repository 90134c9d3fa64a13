#pragma once

#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar {

/// Virtual time now. What a process of a placed program can know of it is what its Timer says.
Time now();

/// The running process waits until the virtual time `due`. If that has passed, it goes on at this moment, but others
/// get their turn, so that a process that polls starves nobody: one that is not placed lets everything happen first
/// that is to happen at this moment; one that is placed pays for the instruction, and its timeslice passes.
void wait_until(Time due, const SourceLocation& = SourceLocation::current());
/// ... for a while. REQUIRES: how_long >= 0.
void wait_for(Time how_long, const SourceLocation& = SourceLocation::current());

/// occam's TIMER: the clock of the running process's priority. High-priority processes see one that ticks
/// every microsecond, low-priority ones every 64 microseconds (INMOS ticks.inc). It does not wrap, as the
/// hardware's 32-bit clock does.
class Timer {
public:
    static constexpr Time high_tick = std::chrono::microseconds{1};
    static constexpr Time low_tick = std::chrono::microseconds{64};

    /// How long a tick of the running process's clock is.
    Time tick() const;
    /// `timer ? t`: whole ticks since the start.
    std::int64_t read() const;
    /// When the clock's reading becomes later than `ticks`: the moment for which `timer ? AFTER ticks` waits.
    Time moment_after(std::int64_t ticks) const;
    /// `timer ? AFTER ticks`.
    void wait_after(std::int64_t ticks, const SourceLocation& = SourceLocation::current()) const;
};

} // namespace placedpar
