#pragma once

#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar {

/// Returns the current virtual time. A placed program should read its Timer instead, as on the real machine.
Time now();

/// Makes the running process wait until the virtual time `due`. If `due` has passed already, other processes still get
/// their turn first, so that a polling process does not starve them: a process that is not placed lets everything else
/// of this instant happen before it continues; a placed process pays for the instruction, so that its timeslice passes.
void wait_until(Time due, const SourceLocation& = SourceLocation::current());
/// Makes the running process wait for the given time. REQUIRES: how_long >= 0.
void wait_for(Time how_long, const SourceLocation& = SourceLocation::current());

/// Makes the running process wait until the work of the simulation is over, that is, until nothing can happen any more
/// unless a process that waits in this function continues. Activity after the work, such as a test of the machine's
/// final state, is not counted in the run's time, trace or time limit.
void wait_until_work_is_over(const SourceLocation& = SourceLocation::current());

// occam's arithmetic for readings of a 32-bit clock, which wraps round after 71 minutes and 35 seconds at high
// priority, and after 76 hours at low. A T2's clocks have 16 bits, like its words; Timer applies the same rules to
// them.

/// `a PLUS b`
constexpr std::int32_t plus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
/// `a MINUS b`: the ticks from b to a, if they are fewer than half a round.
constexpr std::int32_t minus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
/// `a AFTER b`: whether a is later than b, if they are less than half a round apart.
constexpr bool is_after(std::int32_t a, std::int32_t b) { return minus(a, b) > 0; }

/// occam's TIMER: the clock that the running process's executive shows to processes of its priority. A reading has the
/// bits of a word: 32, or 16 in a T2. On a T2 a reading is a number from -32768 to 32767, and the clock wraps round
/// after 65.5 ms at high priority and after 4.19 s at low priority. Numbers given by a program are reduced to the same
/// bits.
class Timer {
public:
    /// Returns the period of the running process's clock; a microsecond if the process is not placed.
    Time tick() const;
    /// Returns the bits of a clock reading: 32 for a process that is not placed.
    int bits() const;
    /// `timer ? t`: the lowest bits of the number of whole ticks since the start of the run.
    std::int32_t read() const;
    /// `a PLUS b`, `a MINUS b` and `a AFTER b` in words of the running process's executive.
    std::int32_t plus(std::int32_t a, std::int32_t b) const;
    std::int32_t minus(std::int32_t a, std::int32_t b) const;
    bool is_after(std::int32_t a, std::int32_t b) const { return minus(a, b) > 0; }
    /// Returns the time at which the clock's reading becomes later than `ticks`; `timer ? AFTER ticks` waits until
    /// then. If the reading is later already, returns a time that is not in the future.
    Time moment_after(std::int32_t ticks) const;
    /// `timer ? AFTER ticks`.
    void wait_after(std::int32_t ticks, const SourceLocation& = SourceLocation::current()) const;
};

} // namespace placedpar
