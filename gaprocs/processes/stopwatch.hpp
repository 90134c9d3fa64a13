#pragma once

#include "runtime/timer.hpp"

#include <cstdint>

namespace placedpar {

/// Measures a section of a process's program repeatedly with the transputer's timer, as the thesis did, and computes
/// the mean time. At low priority the timer's clock ticks only every 64 us.
class Stopwatch {
public:
    void start() { started_ = timer_.read(); }
    /// REQUIRES: the process has the same priority as at start(), because each priority has its own clock. Also
    /// requires that less than half of the clock's period has passed since start(). On a T2 at low priority, half of
    /// the period is 2.1 s.
    void stop() {
        measured_ += timer_.minus(timer_.read(), started_) * timer_.tick();
        ++times_;
    }
    /// Returns the mean time in milliseconds, or 0 if stop() was never called. May be called at either priority.
    double mean_milliseconds() const { return times_ ? in_milliseconds(measured_) / static_cast<double>(times_) : 0; }

private:
    Timer timer_;
    std::int32_t started_ = 0;
    Time measured_{};
    std::int64_t times_ = 0;
};

} // namespace placedpar
