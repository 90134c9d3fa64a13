#pragma once

#include "runtime/timer.hpp"

#include <cstdint>

namespace placedpar {

/// Measures a stretch of a process's program again and again with the transputer's timer, as the thesis did,
/// and gives the mean. A low-priority process reads a clock of 64 us, so a single reading is that coarse.
class Stopwatch {
public:
    void start() { started_ = timer_.read(); }
    void stop() { add(timer_.read() - started_); }
    void add(std::int64_t ticks) {
        ticks_ += ticks;
        ++times_;
    }
    /// 0 if it was never stopped. REQUIRES: called by the process that did the measuring.
    double mean_milliseconds() const {
        return times_ ? static_cast<double>(ticks_) * in_milliseconds(timer_.tick()) / static_cast<double>(times_) : 0;
    }

private:
    Timer timer_;
    std::int64_t started_ = 0;
    std::int64_t ticks_ = 0;
    std::int64_t times_ = 0;
};

} // namespace placedpar
