#pragma once

#include "runtime/timer.hpp"

#include <cstdint>

namespace placedpar {

/// Measures a stretch of a process's program again and again with the transputer's timer, as the thesis did,
/// and gives the mean. A low-priority process reads a clock of 64 us, so a single reading is that coarse.
class Stopwatch {
public:
    void start() { started_ = timer_.read(); }
    /// REQUIRES: the priority of start(), whose clock it was, and less than half of the clock's round since then: on a
    /// T2 at low priority 2.1 s.
    void stop() {
        measured_ += timer_.minus(timer_.read(), started_) * timer_.tick();
        ++times_;
    }
    /// 0 if it was never stopped. May be asked at either priority.
    double mean_milliseconds() const { return times_ ? in_milliseconds(measured_) / static_cast<double>(times_) : 0; }

private:
    Timer timer_;
    std::int32_t started_ = 0;
    Time measured_{};
    std::int64_t times_ = 0;
};

} // namespace placedpar
