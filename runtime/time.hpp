#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace placedpar {

/// Virtual time since the start of the simulation, in whole picoseconds. The cycles of 20 and 25 MHz clocks, and the
/// bits of 5, 10 and 20 Mbit/s links, are whole numbers of picoseconds. Virtual time ends after 106 days. Time::max()
/// stands for any later time, and is never reached: if only such events are left, the run ends with an error.
using Time = std::chrono::duration<std::int64_t, std::pico>;

/// Cycles of a processor's clock. The type is distinct, so that the compiler does not mix up cycles and times.
enum class Cycles : std::int64_t {};

constexpr Cycles operator+(Cycles a, Cycles b) {
    return Cycles{static_cast<std::int64_t>(a) + static_cast<std::int64_t>(b)};
}
constexpr Cycles operator*(std::int64_t n, Cycles c) { return Cycles{n * static_cast<std::int64_t>(c)}; }

/// An integer of 128 bits. duration_of() needs so many bits above 9.2 million periods.
__extension__ typedef __int128 WideInteger;

/// Converts a number of picoseconds to a time. A number that is too large becomes Time::max(). REQUIRES: count >= 0.
constexpr Time clamped(WideInteger count) {
    return count > Time::max().count() ? Time::max() : Time{static_cast<std::int64_t>(count)};
}

/// Returns the duration of `periods` periods at a frequency, rounded to the nearest picosecond, at most Time::max(). A
/// period is a cycle of a clock or a bit on a wire. REQUIRES: periods >= 0, hertz > 0.
constexpr Time duration_of(std::int64_t periods, std::int64_t hertz) {
    constexpr std::int64_t picoseconds_in_a_second = 1'000'000'000'000;
    return clamped((WideInteger{periods} * picoseconds_in_a_second + hertz / 2) / hertz);
}

/// Returns `n * each`, at most Time::max(). REQUIRES: n >= 0, each >= 0.
constexpr Time times(std::int64_t n, Time each) { return clamped(WideInteger{n} * each.count()); }

/// Returns `t + by`, at most Time::max(). REQUIRES: t >= 0.
constexpr Time later(Time t, Time by) { return by > Time::max() - t ? Time::max() : t + by; }

/// Converts cycles of a clock to time. Gives the results of duration_of(), but in most cases without the slow division
/// of 128 bits.
class Clock {
public:
    /// REQUIRES: hertz > 0.
    explicit constexpr Clock(std::int64_t hertz) : hertz_(hertz), cycle_(1'000'000'000'000 / hertz) {}

    constexpr std::int64_t hertz() const { return hertz_; }
    /// Returns the duration of the given number of cycles. REQUIRES: cycles >= 0.
    constexpr Time duration(std::int64_t cycles) const {
        if (left_ == 0)
            return times(cycles, cycle_);
        if (cycles > most_)
            return duration_of(cycles, hertz_);
        return later(times(cycles, cycle_), Time{(cycles * left_ + hertz_ / 2) / hertz_});
    }

private:
    std::int64_t hertz_;
    Time cycle_; ///< rounded down
    /// A cycle lasts left_ / hertz_ picoseconds longer than cycle_.
    std::int64_t left_ = 1'000'000'000'000 % hertz_;
    /// The largest number of cycles for which 64 bits are enough.
    std::int64_t most_ = (Time::max().count() - hertz_ / 2) / (left_ + 1);
};

constexpr double in_milliseconds(Time t) { return static_cast<double>(t.count()) * 1e-9; }

/// Formats a time for reports in a unit that suits its size: "1.234567 ms".
std::string to_string(Time);

} // namespace placedpar
