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

/// The part of a run that is traced.
struct TraceWindow {
    Time from{}, until = Time::max();
    std::size_t most_entries = 2'000'000; ///< number of slices and messages at which the trace ends

    bool is_part() const { return from > Time{} || until < Time::max(); }
};

/// Returns the window. Throws UserError if the window is empty.
const TraceWindow& require_time_in(const TraceWindow&);

/// Converts the kernel's notices about a run into slices on tracks, for a writer of a trace file. A track is the
/// timeline of a processor, process, link or bus; a slice is an interval of one activity. A slice ends when the process
/// changes its activity. If a process stops computing and computes again at the same time, its slice continues, unless
/// a message was passed in between. A wait lasts until its process continues.
class Timeline final : public ActivityLog<Timeline> {
public:
    /// REQUIRES: the tracks and the writer outlive this object.
    Timeline(Tracks&, const TraceWindow&, TraceWriter&);

    /// Returns the time at which the trace became full; nothing if it is not full.
    std::optional<Time> full_at() const { return full_at_; }
    /// Returns why no part of the run is in the window; "" if some part is. REQUIRES: the run is over.
    std::string why_empty() const;
    /// Completes the trace. A wait that never ended, or that ended after the end of the trace, is written as open, that
    /// is, without an end. A wait that ended only because the work of the run was over (see wait_until_work_is_over) is
    /// not open. The trace says that the run ended as `result` does, or, if `ended` is not "", as `ended` does: an
    /// error of a program is not part of the result. REQUIRES: the run is over.
    void finish(const RunResult& result, const std::string& ended = "");

    void turns(const Process&, Activity, Time) override;
    void program_turns(const ProgramTurn&, Time) override;
    void communicated(const AnyChannel&, Time) override;
    void takes(const PlaceTaken&, Time now) override;
    void leaves(const PlaceLeft&, Time now) override;
    void program_communicates(const MessagePart&, Time) override;
    void over(Time) override;
    void ends_early(Time, const std::string& why) override;

private:
    friend class ActivityLog<Timeline>;
    /// The sending or receiving end of a message, until the slice that contains this end is known.
    struct MessageEnd {
        std::uint64_t message;
        bool arrives;
    };
    /// State of a process, and of its track.
    struct Lane {
        std::size_t track;
        const Process* process;
        Activity activity;
        Time since;
        std::optional<Time> stopped = {};   ///< time at which the process stopped computing; empty while the process
                                            ///< computes
        std::optional<Time> last_end = {};  ///< end of its last slice
        Time waited_since{};                ///< beginning of its last wait
        std::size_t partner = Tracks::none; ///< track of the partner of the present wait
        std::vector<MessageEnd> here = {};  ///< ends of messages that belong to the next slice with a duration
        std::vector<std::uint64_t> arriving = {}; ///< messages that end the present wait
        std::optional<Slice> last = {};           ///< slice at the end of the trace, once the trace has ended
        std::string path = {};                    ///< path of the process, once the trace has ended
    };
    /// The present use of a processor, a direction of a link, or a bus.
    struct Use {
        std::string subject;
        Time since;
        std::optional<Time> stopped = {};
        std::uint64_t bytes = 0;
    };
    /// State of a process that is known only by its name: a process of a booted program or of a native run.
    struct ProgramLane {
        std::size_t track;
        Activity activity = Activity::ended;
        Time since{};
        std::vector<Awaited> awaited = {};
        bool awaits_timer = false;
        std::vector<MessageEnd> here = {};        ///< see Lane::here
        std::vector<std::uint64_t> arriving = {}; ///< see Lane::arriving
    };
    /// The last wait of a booted program's process for a channel that leads over a link to a process.
    struct ProgramUse {
        std::size_t track;
        Time since;
        std::optional<Time> ended = {};
        std::vector<std::uint64_t> arriving = {}; ///< messages that end the wait
    };
    struct Message {
        std::string channel;
        Time at;
        std::size_t from = Tracks::none, to = Tracks::none;
        Time left{}, arrived{};
        /// The times come from two clocks, so the message may seem to arrive before it leaves.
        bool by_two_clocks = false;
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
    void close(ProgramLane&, Time end, bool open);
    void finish(ProgramLane&, bool open);
    void use_links(const ProgramLane&);
    void leave_links(const ProgramLane&, Time now);
    void pass(const AnyChannel&, Lane* from, Lane* to, Time now);
    void place(const MessageEnd&, std::size_t track, Time);
    void give_up(Lane&);
    bool write(Slice);

    Tracks& tracks_;
    TraceWindow window_;
    TraceWriter& writer_;
    std::map<std::uint32_t, Lane> lanes_;            ///< key: ordinal of a living process
    std::map<std::string, ProgramLane> programs_;    ///< key: name of the process
    std::map<std::string, ProgramUse> program_uses_; ///< key: name of the channel
    std::map<std::size_t, Use> uses_; ///< for each track: the present use, or the last use if the track is idle
    std::map<std::uint64_t, Message> messages_; ///< messages of which one end's slice is not known yet
    std::uint64_t message_count_ = 0;
    std::size_t entries_ = 0;
    std::optional<Time> full_at_;
    std::optional<Time> end_; ///< end of the trace
    std::string why_;         ///< why the trace ended before the run; "" if it did not
};

} // namespace placedpar
