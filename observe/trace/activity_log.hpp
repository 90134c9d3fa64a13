#pragma once

#include "runtime/trace.hpp"

#include <stdexcept>

namespace placedpar {

/// Sorts the kernel's notices about processes for a derived class, the Reader: for each kind of notice it calls a
/// function of the Reader. A Reader has a map `lanes_` with its data about each living process (the lane), by the
/// process's ordinal, and these functions:
///   begin(process, now)           the process begins to exist; the process is ignored if no lane is added here;
///   wait(lane, activity, now)     a wait begins;
///   become_ready(lane, now)       a wait or a computation is over, but the program does not run yet;
///   go_on(lane, now)              the program runs again after a wait;
///   compute(lane, activity, now)  the process computes, or moves words;
///   end(lane, now)                the process ends; the lane is removed afterwards.
template <class Reader>
class ActivityLog : public TraceSink {
protected:
    ~ActivityLog() = default;

    /// Returns the process's lane; null if there is no process or it has no lane.
    auto* lane_of(const Process* process) {
        auto& lanes = reader().lanes_;
        auto found = process ? lanes.find(process->ordinal()) : lanes.end();
        return found == lanes.end() ? nullptr : &found->second;
    }

    void tell(const Process& process, Activity activity, Time now) {
        if (activity == Activity::starting)
            return reader().begin(process, now);
        auto* lane = lane_of(&process);
        if (!lane)
            return;
        switch (activity) {
        case Activity::ready: return reader().become_ready(*lane, now);
        case Activity::executing: return reader().go_on(*lane, now);
        case Activity::computing:
        case Activity::moving: return reader().compute(*lane, activity, now);
        case Activity::delayed:
        case Activity::outputting:
        case Activity::inputting:
        case Activity::alternating:
        case Activity::joining:
        case Activity::after_work:
        case Activity::stopped: return reader().wait(*lane, activity, now);
        case Activity::ended: return reader().end(*lane, now), void(reader().lanes_.erase(process.ordinal()));
        case Activity::starting:
        case Activity::carrying:
        case Activity::arbitrating:
        case Activity::halted: break;
        }
        throw std::logic_error("the kernel has reported an activity that no process can have");
    }

private:
    Reader& reader() { return static_cast<Reader&>(*this); }
};

} // namespace placedpar
