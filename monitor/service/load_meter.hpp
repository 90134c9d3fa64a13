#pragma once

#include "monitor/protocol/answers.hpp"

#include <chrono>
#include <cstdint>

namespace placedpar::monitor {

/// Counts the work of the service and measures the time for it, for reports to clients. Use it only in the service's
/// thread, because it reads the processor time of the calling thread.
class LoadMeter {
public:
    using Clock = std::chrono::steady_clock;

    LoadMeter();

    void count_sample(std::size_t generations);
    /// Counts time spent on a message.
    void count_work(Clock::duration spent);
    /// Counts the time of a turn of the event loop, during which no client was served.
    void count_turn(Clock::duration spent);
    /// Ends the interval over which rates are measured, if it has lasted 1 s.
    void tick();

    /// Returns totals since the start, and rates over the last complete interval. Before the first interval is
    /// complete, the rates are over the time since the start. Does not set the numbers of clients, machines and queued
    /// bytes.
    Load load() const;

private:
    struct Totals {
        Clock::time_point time;
        std::uint64_t samples = 0, generations = 0;
        double work_s = 0, cpu_s = 0;
    };
    static LoadRates between(const Totals& from, const Totals& to);
    Totals read() const;

    Totals now_, start_, last_;
    LoadRates rates_;
    double longest_turn_s_ = 0;
};

} // namespace placedpar::monitor
