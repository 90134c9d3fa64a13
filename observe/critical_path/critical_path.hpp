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

/// Finds the critical path of a run while it goes on. For each thing that happens it notes what had to happen before
/// it: for a message the later one of the two processes to come to the channel, for a turn on a processor who had it
/// until then, for the end of a PAR its last component. From the end of the run that leads back to its beginning
/// without a gap, since each thing begins when the one before it ends.
class CriticalPath final : public ActivityLog<CriticalPath> {
public:
    /// Where the path comes to have more points, nothing of it is kept, and what follows of a run takes no more memory.
    explicit CriticalPath(std::size_t most_points = most_path_points);

    bool too_long() const { return points_.too_long(); }
    /// In order of time; their lengths add up to the run's: throws std::logic_error if not. None where the path is too
    /// long. REQUIRES: the run is over.
    std::vector<PathPart> parts() const;
    /// How the time of each process of the netlist went by. REQUIRES: the run is over.
    const std::map<std::string, Account>& accounts() const { return accounts_.all(); }

    /// By direction of a link: how long outputters were in it before their inputters came.
    const std::map<std::string, Time>& waits_at_links() const { return waits_at_links_; }

    void turns(const Process&, Activity, Time) override;
    void communicated(const AnyChannel&, Time) override;
    void takes(const PlaceTaken&, Time) override;
    void leaves(const PlaceLeft&, Time) override;
    void over(Time) override;

private:
    friend class ActivityLog<CriticalPath>;
    using Number = PathPoints::Number;
    using Point = PathPoints::Point;
    struct Lane {
        Number last; ///< what it did last; while it waits, its coming
        const Process* process;
        Activity does = Activity::ended;
        std::optional<Number> cause = {};    ///< why its wait is over, while it has not gone on
        std::optional<Number> together = {}; ///< of a message: when both were in the channel
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
    std::unordered_map<std::string, std::uint32_t> numbers_;        ///< of subjects and places
    std::map<std::uint32_t, Lane> lanes_;                           ///< of the processes that live, by ordinal
    std::unordered_map<const Executive*, Number> held_;             ///< what was last done on each
    std::unordered_map<std::string, Number> bus_held_;              ///< what each bus was last used for
    std::map<std::pair<const AnyChannel*, bool>, Number> came_;     ///< to an end of a hard channel; true: to output
    std::unordered_map<const AnyChannel*, std::string> carried_by_; ///< the direction of a link
    std::map<std::string, Time> waits_at_links_;
    Accounts accounts_;
    Number end_ = 0;
    Time over_{};
};

/// The lengths of a path's parts by what they were spent with, the longest first.
struct PathShare {
    Activity activity;
    std::string subject;
    Time time;
};
std::vector<PathShare> shares_of(const std::vector<PathPart>&);
/// "computing: master on t[0]".
std::string name_of(const PathShare&);
/// The same with arrays taken together: "computing: slave[] on t[]".
std::vector<PathShare> shares_by_array(const std::vector<PathPart>&);

} // namespace placedpar
