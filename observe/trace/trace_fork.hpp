#pragma once

#include "runtime/trace.hpp"

#include <utility>
#include <vector>

namespace placedpar {

/// Tells several sinks of one run.
class TraceFork final : public TraceSink {
public:
    /// REQUIRES: they outlive it.
    explicit TraceFork(std::vector<TraceSink*> sinks) : sinks_(std::move(sinks)) {}

    void began(const Process& process, Time now) override { tell(&TraceSink::began, process, now); }
    void waits(const Process& process, Time now) override { tell(&TraceSink::waits, process, now); }
    void made_ready(const Process& process, Time now) override { tell(&TraceSink::made_ready, process, now); }
    void goes_on(const Process& process, Time now) override { tell(&TraceSink::goes_on, process, now); }
    void computes(const Process& process, Time now) override { tell(&TraceSink::computes, process, now); }
    void stops_computing(const Process& process, Time now) override { tell(&TraceSink::stops_computing, process, now); }
    void moves(const Process& process, Time now) override { tell(&TraceSink::moves, process, now); }
    void moved(const Process& process, const std::string& bus, Time since, Time now) override {
        tell(&TraceSink::moved, process, bus, since, now);
    }
    void ended(const Process& process, Time now) override { tell(&TraceSink::ended, process, now); }
    void communicated(const AnyChannel& channel, Time now) override { tell(&TraceSink::communicated, channel, now); }
    void carries(const std::string& direction, const AnyChannel& channel, Time now, Time since) override {
        tell(&TraceSink::carries, direction, channel, now, since);
    }
    void carried(const std::string& direction, std::uint64_t bytes, Time now, Time until) override {
        tell(&TraceSink::carried, direction, bytes, now, until);
    }
    void occupied(const std::string& track, const std::string& subject, Time now) override {
        tell(&TraceSink::occupied, track, subject, now);
    }
    void vacated(const std::string& track, Time now) override { tell(&TraceSink::vacated, track, now); }
    void over(Time now) override { tell(&TraceSink::over, now); }

private:
    template <class Notice, class... What>
    void tell(Notice notice, const What&... what) {
        for (TraceSink* sink : sinks_)
            (sink->*notice)(what...);
    }

    std::vector<TraceSink*> sinks_;
};

} // namespace placedpar
