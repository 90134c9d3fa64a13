#pragma once

#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar {

/// Returns the current virtual time. A process on an executive should read its Timer instead, as on the real machine.
Time now();

/// Makes the running process wait until the virtual time `due`. If `due` has passed already, other processes still get
/// their turn first, so a polling process cannot starve them. A process without an executive continues after all other
/// events of the current instant. A process on an executive pays for the instruction, so its timeslice passes.
void wait_until(Time due, const SourceLocation& = SourceLocation::current());
/// Makes the running process wait for the given time. REQUIRES: how_long >= 0.
void wait_for(Time how_long, const SourceLocation& = SourceLocation::current());

/// Makes the running process wait until the work of the simulation is over. The work is over when nothing more can
/// happen, except by processes that wait in this function. Activity after the work, such as a test of the machine's
/// final state, is not included in the run's time, trace or time limit.
void wait_until_work_is_over(const SourceLocation& = SourceLocation::current());

// These functions are occam's arithmetic for readings of a 32-bit clock. Such a clock wraps round after 71 minutes and
// 35 seconds at high priority, and after 76 hours at low priority. A T2's clocks have 16 bits, like its words; Timer
// applies the same rules to them.

/// Returns `a PLUS b`.
constexpr std::int32_t plus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
/// Returns `a MINUS b`: the ticks from b to a, if they are fewer than half the range of the clock.
constexpr std::int32_t minus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
/// Returns `a AFTER b`: whether a is later than b, if the two are less than half the range of the clock apart.
constexpr bool is_after(std::int32_t a, std::int32_t b) { return minus(a, b) > 0; }

/// occam's TIMER: the clock that the running process's executive shows to processes of the same priority. A reading has
/// the bits of a word: 32, or 16 on a T2. On a T2 a reading is a number from -32768 to 32767, and the clock wraps round
/// after 65.5 ms at high priority and after 4.19 s at low priority. Numbers that a program passes are reduced to the
/// same number of bits.
class Timer {
public:
    /// Returns the tick of the running process's clock, or a microsecond if the process has no executive.
    Time tick() const;
    /// Returns the number of bits of a clock reading, or 32 if the process has no executive.
    int bits() const;
    /// Returns the reading of `timer ? t`: the lowest bits of the number of whole ticks since the start of the run.
    std::int32_t read() const;
    /// Return `a PLUS b`, `a MINUS b` and `a AFTER b`, with numbers of bits() bits.
    std::int32_t plus(std::int32_t a, std::int32_t b) const;
    std::int32_t minus(std::int32_t a, std::int32_t b) const;
    bool is_after(std::int32_t a, std::int32_t b) const { return minus(a, b) > 0; }
    /// Returns the time at which the clock's reading becomes later than `ticks`. `timer ? AFTER ticks` waits until
    /// then. If the reading is already later, returns the present time or an earlier time.
    Time moment_after(std::int32_t ticks) const;
    /// Waits as `timer ? AFTER ticks` does.
    void wait_after(std::int32_t ticks, const SourceLocation& = SourceLocation::current()) const;
};

} // namespace placedpar
