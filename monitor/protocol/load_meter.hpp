#pragma once

#include <chrono>
#include <cstdint>

namespace placedpar::monitor {

/// What the service has to do, and what that takes: totals, and rates over the last whole second or more.
class LoadMeter {
public:
    using Clock = std::chrono::steady_clock;

    struct Rates {
        double over_s = 0;
        double samples_per_s = 0;
        double generations_per_s = 0;
        double work_of_core = 0; // time spent on messages, as a fraction of one core
        double cpu_of_core = 0;  // processor time of this thread, the network's share included
    };

    LoadMeter();

    void count_sample(std::size_t generations);
    void count_work(Clock::duration spent) { now_.work_s += std::chrono::duration<double>(spent).count(); }
    /// Ends the interval once it has lasted a second. To be called from the service's thread.
    void tick();

    std::uint64_t samples() const { return now_.samples; }
    std::uint64_t generations() const { return now_.generations; }
    /// Spent on messages, in all.
    double work_s() const { return now_.work_s; }
    /// Of processor time of this thread, in all.
    double cpu_s() const;
    double uptime_s() const;
    /// Of the last ended interval; of the time since the start before there is one.
    Rates rates() const;

private:
    struct Totals {
        Clock::time_point time;
        std::uint64_t samples = 0, generations = 0;
        double work_s = 0, cpu_s = 0;
    };
    static Rates between(const Totals& from, const Totals& to);
    Totals read() const;

    Totals now_, start_, last_;
    Rates rates_;
};

} // namespace placedpar::monitor
