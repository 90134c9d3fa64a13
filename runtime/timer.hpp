#pragma once

#include "runtime/source_location.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar {

/// Returns the current virtual time. A process on a processor should read its Timer instead, as on the real machine.
Time now();

/// Makes the running process wait until the virtual time `due`. If `due` has passed already, other processes still get
/// their turn, so a polling process cannot block them. A process without a processor continues after all other events
/// of the current instant. For a process on a processor the instruction takes time, so the process's timeslice ends in
/// the end.
void wait_until(Time due, const SourceLocation& = SourceLocation::current());
/// Makes the running process wait for the given time. REQUIRES: how_long >= 0.
void wait_for(Time how_long, const SourceLocation& = SourceLocation::current());

/// Makes the running process wait until the simulation's work is over, that is, until nothing more can happen. The
/// process can then test the machine's final state, for example. What happens after the work is not part of the run's
/// time and trace, and has no time limit.
void wait_until_work_is_over(const SourceLocation& = SourceLocation::current());

// occam's arithmetic for readings of a 32-bit clock follows. Such a clock wraps round after 71 minutes and 35 seconds
// at high priority, and after 76 hours at low priority. For the 16-bit clocks of a T2, call the functions of Timer.

/// Returns `a PLUS b`.
constexpr std::int32_t plus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
/// Returns `a MINUS b`: the ticks from b to a, if they are fewer than half the range of the clock.
constexpr std::int32_t minus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
/// Returns `a AFTER b`: whether a is later than b. REQUIRES: a and b are less than half the range of the clock apart.
constexpr bool is_after(std::int32_t a, std::int32_t b) { return minus(a, b) > 0; }

/// occam's TIMER: the clock of the running process's processor for the process's priority. A reading has the bits of a
/// word: 32, or 16 on a T2. On a T2 a reading is a number from -32768 to 32767, and the clock wraps round after 65.5 ms
/// at high priority and after 4.19 s at low priority. The functions use only this number of bits of their arguments.
class Timer {
public:
    /// Returns the length of a tick of the running process's clock, or a microsecond if the process has no processor.
    Time tick() const;
    /// Returns the number of bits of a clock reading, or 32 if the process has no processor.
    int bits() const;
    /// Returns the reading of `timer ? t`: the lowest bits of the number of whole ticks since the start of the run.
    std::int32_t read() const;
    /// Return `a PLUS b`, `a MINUS b` and `a AFTER b`, with numbers of bits() bits.
    std::int32_t plus(std::int32_t a, std::int32_t b) const;
    std::int32_t minus(std::int32_t a, std::int32_t b) const;
    bool is_after(std::int32_t a, std::int32_t b) const { return minus(a, b) > 0; }
    /// Returns the virtual time until which `timer ? AFTER ticks` waits, that is, the time at which the reading becomes
    /// later than `ticks`. If the reading is already later, returns the present time or an earlier time.
    Time moment_after(std::int32_t ticks) const;
    /// Waits as `timer ? AFTER ticks` does.
    void wait_after(std::int32_t ticks, const SourceLocation& = SourceLocation::current()) const;
};

} // namespace placedpar
