#pragma once

#include "runtime/trace.hpp"

#include <utility>
#include <vector>

namespace placedpar {

/// Passes the notices of one run on to several receivers (sinks), such as a trace file and the critical path.
class TraceFork final : public TraceSink {
public:
    /// REQUIRES: the sinks outlive this object.
    explicit TraceFork(std::vector<TraceSink*> sinks) : sinks_(std::move(sinks)) {}

    void turns(const Process& process, Activity activity, Time now) override {
        tell(&TraceSink::turns, process, activity, now);
    }
    void program_turns(const ProgramTurn& turn, Time now) override { tell(&TraceSink::program_turns, turn, now); }
    void communicated(const AnyChannel& channel, Time now) override { tell(&TraceSink::communicated, channel, now); }
    void takes(const PlaceTaken& taken, Time now) override { tell(&TraceSink::takes, taken, now); }
    void leaves(const PlaceLeft& left, Time now) override { tell(&TraceSink::leaves, left, now); }
    void program_communicates(const MessagePart& part, Time now) override {
        tell(&TraceSink::program_communicates, part, now);
    }
    void ends_early(Time now, const std::string& why) override { tell(&TraceSink::ends_early, now, why); }
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
