#pragma once

#include "observe/trace/activity_log.hpp"
#include "observe/trace/trace_writer.hpp"
#include "runtime/simulation.hpp"
#include "runtime/trace.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace placedpar {

/// Which part of a run is traced.
struct TraceWindow {
    Time from{}, until = Time::max();
    std::size_t most_entries = 2'000'000; ///< slices and messages; the trace ends when there are so many

    bool is_part() const { return from > Time{} || until < Time::max(); }
};

/// Throws UserError when the window is empty.
const TraceWindow& require_time_in(const TraceWindow&);

/// Makes slices on tracks of what it is told of a run. A slice ends when a process does something else; one that
/// computes again at once goes on, unless a message was handed over in between. A wait lasts until its process goes on.
class Timeline final : public ActivityLog<Timeline> {
public:
    /// REQUIRES: the tracks and the writer outlive it.
    Timeline(Tracks&, const TraceWindow&, TraceWriter&);

    /// When the trace was full, if it was.
    std::optional<Time> full_at() const { return full_at_; }
    /// Why nothing of the run lies in the window, where that is so; else "". REQUIRES, as finish(): the run is over.
    std::string why_empty() const;
    /// Of the run. A wait is left open where it never ended, or ended behind the trace; not one that ended after the
    /// work (see wait_until_work_is_over), which is not traced.
    void finish(const RunResult&);

    void turns(const Process&, Activity, Time) override;
    void communicated(const AnyChannel&, Time) override;
    void takes(const PlaceTaken&, Time now) override;
    void leaves(const PlaceLeft&, Time now) override;
    void over(Time) override;

private:
    friend class ActivityLog<Timeline>;
    /// One end of a message, until the slice in which it lies is known.
    struct MessageEnd {
        std::uint64_t message;
        bool arrives;
    };
    /// What the process does that a track is of.
    struct Lane {
        std::size_t track;
        const Process* process;
        Activity activity;
        Time since;
        std::optional<Time> stopped = {};         ///< of one that computes: until then
        std::optional<Time> last_end = {};        ///< of its last slice
        std::size_t partner = Tracks::none;       ///< with whom it communicated during the present wait
        std::vector<MessageEnd> here = {};        ///< in the next slice that lasts
        std::vector<std::uint64_t> arriving = {}; ///< messages that end the present wait
        std::optional<Slice> last = {};           ///< when the trace has ended, what the process did then
        std::string path = {};                    ///< then: the process's
    };
    /// What a processor executes, a link carries, or a bus does.
    struct Use {
        std::string subject;
        Time since;
        std::optional<Time> stopped = {};
        std::uint64_t bytes = 0;
    };
    struct Message {
        std::string channel;
        Time at;
        std::size_t from = Tracks::none, to = Tracks::none;
        Time left{}, arrived{};
    };

    bool taking(Time now);
    void shut(Time now, const std::string& why);
    void begin(const Process&, Time now);
    void wait(Lane& lane, Activity activity, Time now) { turn_to(lane, activity, now); }
    void become_ready(Lane&, Time now);
    void go_on(Lane&, Time now);
    void compute(Lane&, Activity, Time now);
    void end(Lane&, Time now);
    std::size_t processor_of(const Lane&) const;
    void turn_to(Lane&, Activity, Time now);
    void settle(Lane&, Time now);
    void close(Lane&, Time end);
    bool close(Lane&, Slice);
    Slice slice_of(const Lane&, Time end, bool open) const;
    std::string partner(const Lane&, const AnyChannel&, bool open) const;
    void use(std::size_t track, const std::string& subject, Time now);
    void close_use(std::size_t track, Time now);
    void finish(Lane&, const RunResult&);
    void place(const MessageEnd&, std::size_t track, Time);
    void give_up(Lane&);
    bool write(Slice);

    Tracks& tracks_;
    TraceWindow window_;
    TraceWriter& writer_;
    std::map<std::uint32_t, Lane> lanes_;       ///< of the processes that live, by ordinal
    std::map<std::size_t, Use> uses_;           ///< by track: the present one, or the last
    std::map<std::uint64_t, Message> messages_; ///< of which an end is not known yet
    std::uint64_t message_count_ = 0;
    std::size_t entries_ = 0;
    std::optional<Time> full_at_;
    std::optional<Time> end_; ///< of the trace
    std::string why_;         ///< it ended before the run; else empty
};

} // namespace placedpar
