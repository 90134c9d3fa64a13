#pragma once

#include "observe/critical_path/path_points.hpp"
#include "observe/critical_path/waits.hpp"
#include "observe/trace/activity_log.hpp"
#include "observe/trace/path_part.hpp"
#include "runtime/process.hpp"
#include "runtime/trace.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace placedpar {

/// Records the critical path of a run: the chain of activities without a gap that determines when the run ends. Each
/// event is stored with its cause. The cause of a message is the arrival of the later of its two processes at the
/// channel. The cause of a turn on a processor is the end of the preceding turn; the cause of the end of a PAR is the
/// end of its last component. Because each activity begins when its cause ends, the causes lead from the end of the run
/// to its beginning. The processes inside a booted program have no points on the path; the path leads over the
/// program's host and links. But accounts() includes these processes.
class CriticalPath final : public ActivityLog<CriticalPath> {
public:
    /// If more than `most_points` points are needed, the path is discarded, and the rest of the run takes no further
    /// memory.
    explicit CriticalPath(std::size_t most_points = most_path_points);

    bool too_long() const { return points_.too_long(); }
    /// Returns the parts of the path in order of time; empty if the path is too long. Throws std::logic_error if their
    /// durations do not add up to the run's duration. REQUIRES: the run is over.
    std::vector<PathPart> parts() const;
    /// Returns how each process of the netlist spent its time. REQUIRES: the run is over.
    const std::map<std::string, Account>& accounts() const { return accounts_.all(); }

    /// Returns for each direction of a link how long senders waited for receivers.
    const std::map<std::string, Time>& waits_at_links() const { return waits_at_links_; }

    void turns(const Process&, Activity, Time) override;
    void program_turns(const ProgramTurn&, Time) override;
    void communicated(const AnyChannel&, Time) override;
    void takes(const PlaceTaken&, Time) override;
    void leaves(const PlaceLeft&, Time) override;
    void over(Time) override;

private:
    friend class ActivityLog<CriticalPath>;
    using Number = PathPoints::Number;
    using Point = PathPoints::Point;
    struct Lane {
        Number last; ///< last event of the process; while the process waits, the beginning of the wait
        const Process* process;
        Activity does = Activity::ended;
        std::optional<Number> cause = {};    ///< event that ended the wait; empty once the process has continued
        std::optional<Number> together = {}; ///< for the present message: the later of the two arrivals at the channel
    };

    std::uint32_t number_of(const std::string& subject);
    Number add(Number before, Time at, Activity, const std::string& subject, const std::string& place);
    Number add(Number before, Time at, Activity, const Process&);
    Number add_message(Number before, const Lane&, const AnyChannel&, Time now);
    Number later(Number, Number) const;
    std::vector<Number*> numbers_in_use();
    void forget(Time now);
    const Lane* who_runs(const Process& any, Time now);
    Number message_over(const Lane&, const AnyChannel&, Time now);
    Number cause_of(const Lane&, Time now);
    void begin(const Process&, Time now);
    void wait(Lane&, Activity, Time now);
    void become_ready(Lane&, Time now);
    void go_on(Lane&, Time now);
    void compute(Lane&, Activity, Time now);
    void end(Lane&, Time now);
    void has_turn(Lane&, Time now);
    void hold_executive(const Lane&);
    Number turn_of(const Lane&, Number made_ready, Time now);
    void explain_wait(const Lane&, Time now);
    void turn(Lane&, Activity, Time now);

    PathPoints points_;
    std::vector<std::string> subjects_;
    std::unordered_map<std::string, std::uint32_t> numbers_; ///< numbers of subjects and places
    std::map<std::uint32_t, Lane> lanes_;                    ///< key: ordinal of a process that exists
    std::unordered_map<const Executive*, Number> held_;      ///< last event on each executive (a processor's scheduler)
    std::unordered_map<std::string, Number> bus_held_;       ///< last use of each bus
    /// Last arrival at each end of each channel; `true` is the outputting end.
    std::map<std::pair<const AnyChannel*, bool>, Number> came_;
    std::unordered_map<const AnyChannel*, std::string> carried_by_; ///< direction of the link that carries the channel
    std::unordered_map<const AnyChannel*, Time> carried_since_;     ///< when the channel's bytes last began to flow
    std::map<std::string, Time> waits_at_links_;
    /// The activity of a process of a booted program.
    struct ProgramLane {
        Activity does = Activity::ended;
        std::string partner = {}; ///< partner of its wait
    };
    std::map<std::string, ProgramLane> programs_;
    Accounts accounts_;
    Number end_ = 0;
    Time over_{};
};

/// The time that a path spends on one activity of one subject, such as a process on a processor.
struct PathShare {
    Activity activity;
    std::string subject;
    Time time;
};
/// Returns the shares of the path's parts, the longest first.
std::vector<PathShare> shares_of(const std::vector<PathPart>&);
/// Returns a text such as "computing: master on t[0]".
std::string name_of(const PathShare&);
/// Returns shares as shares_of() does, but combines all elements of an array in one share: "computing: slave[] on t[]".
std::vector<PathShare> shares_by_array(const std::vector<PathPart>&);
/// Returns shares that combine all subjects: one for each activity, with the subject "".
std::vector<PathShare> shares_by_activity(const std::vector<PathPart>&);

} // namespace placedpar
