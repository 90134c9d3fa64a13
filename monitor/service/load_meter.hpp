#pragma once

#include "monitor/protocol/answers.hpp"

#include <chrono>
#include <cstdint>

namespace placedpar::monitor {

/// Counts what the service does and the time that it takes. To be used from the service's thread only, whose processor
/// time it reads.
class LoadMeter {
public:
    using Clock = std::chrono::steady_clock;

    LoadMeter();

    void count_sample(std::size_t generations);
    /// Work on a message.
    void count_work(Clock::duration spent);
    /// Other work, during which nobody was heard.
    void count_turn(Clock::duration spent);
    /// Ends the interval of the rates once it has lasted a second.
    void tick();

    /// Totals since the start, and rates over the last ended interval, or since the start while there is none. Knows
    /// nothing of clients, machines and queues.
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
