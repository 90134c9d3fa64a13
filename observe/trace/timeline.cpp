#include "observe/trace/timeline.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

/// Returns whether the last activity of the process never ended: the run was stopped, or the process takes part in the
/// deadlock.
bool never_ends(const std::string& process, const RunResult& result) {
    return result.ending != Ending::completed &&
           (!result.deadlock || std::ranges::find(result.deadlock->processes, process, &StuckProcess::path) !=
                                    result.deadlock->processes.end());
}

} // namespace

const TraceWindow& require_time_in(const TraceWindow& window) {
    if (window.from >= window.until)
        throw UserError(fmt::format("the trace would begin at {} but end at {}: choose a later end",
                                    to_string(window.from), to_string(window.until)));
    return window;
}

Timeline::Timeline(Tracks& tracks, const TraceWindow& window, TraceWriter& writer)
    : tracks_(tracks), window_(window), writer_(writer) {}

std::string Timeline::why_empty() const {
    if (window_.from == Time{} || *end_ > window_.from)
        return "";
    return fmt::format("the run ended at {}, but the trace would begin at {}", to_string(*end_),
                       to_string(window_.from));
}

void Timeline::finish(const RunResult& result, const std::string& ended) {
    for (auto& [ordinal, lane] : lanes_)
        finish(lane, result);
    for (auto& [name, lane] : programs_)
        finish(lane, !why_.empty() || result.ending != Ending::completed);
    lanes_.clear();
    programs_.clear();
    messages_.clear();
    const std::string how = ended.empty() ? name_of(result.ending) : ended;
    writer_.finish(std::min(window_.from, *end_), *end_, why_.empty() ? how : why_);
}

/// Returns whether the trace continues. Ends the trace if it exceeds its window or its limit.
bool Timeline::taking(Time now) {
    if (!end_ && now > window_.until) {
        shut(window_.until, "end of the part that is traced");
    } else if (!end_ && entries_ >= window_.most_entries) {
        full_at_ = now;
        shut(now, "the trace is full");
    }
    return !end_;
}

void Timeline::turns(const Process& process, Activity activity, Time now) {
    if (taking(now))
        tell(process, activity, now);
}

/// Ends the present slice (the interval of one activity) of a booted program's process, which is known by its name, and
/// begins the next slice.
void Timeline::program_turns(const ProgramTurn& turn, Time now) {
    if (!taking(now))
        return;
    auto found = programs_.find(turn.process);
    if (found == programs_.end()) {
        const std::size_t track = tracks_.of(turn);
        if (track == Tracks::none)
            return;
        found = programs_.emplace(turn.process, ProgramLane{track}).first;
    }
    ProgramLane& lane = found->second;
    if (!turn.partner.empty())
        for (Awaited& each : lane.awaited)
            each.partner = turn.partner;
    const std::size_t processor = tracks_.of_place(turn.place);
    if (lane.activity == Activity::computing && !uses_[processor].stopped)
        uses_[processor].stopped = now;
    if (turn.activity == Activity::computing)
        use(processor, turn.process, now);
    close(lane, now, false);
    leave_links(lane, now);
    for (const std::uint64_t message : std::exchange(lane.arriving, {}))
        lane.here.push_back({message, true});
    lane.activity = turn.activity;
    lane.since = now;
    lane.awaited.clear();
    lane.awaits_timer = turn.awaits_timer;
    for (const AwaitedByProgram& each : turn.awaited)
        lane.awaited.push_back({each.channel, each.partner});
    use_links(lane);
}

/// Notes a wait of a booted program's process for links. The partner of such a wait is the link itself.
void Timeline::use_links(const ProgramLane& lane) {
    for (const Awaited& each : lane.awaited)
        if (each.channel == each.partner)
            program_uses_.insert_or_assign(each.channel, ProgramUse{lane.track, lane.since});
}

/// Ends a wait for links. Messages that processes sent over these links arrive now.
void Timeline::leave_links(const ProgramLane& lane, Time now) {
    for (const Awaited& each : lane.awaited)
        if (const auto use = program_uses_.find(each.channel); use != program_uses_.end()) {
            use->second.ended = now;
            for (const std::uint64_t message : std::exchange(use->second.arriving, {}))
                place({message, true}, lane.track, now);
        }
}

/// Writes the present slice, and places the ends of messages that belong to it at its beginning.
void Timeline::close(ProgramLane& lane, Time end, bool open) {
    if (lane.activity == Activity::ended || (end <= window_.from && !open) ||
        !write({lane.track, lane.activity, lane.since, end, open, {}, 0, lane.awaited, lane.awaits_timer}))
        return;
    for (const MessageEnd& message : std::exchange(lane.here, {}))
        place(message, lane.track, std::max(lane.since, window_.from));
}

/// Notes that a process of a booted program has output or input a message. Such a process is known only by its name.
void Timeline::program_communicates(const MessagePart& part, Time now) {
    const auto found = programs_.find(part.process);
    if (!taking(now) || now < window_.from || found == programs_.end())
        return;
    ProgramLane& lane = found->second;
    messages_.try_emplace(part.message, Message{.channel = part.channel, .at = now, .by_two_clocks = true});
    if (is_waiting(lane.activity)) {
        for (Awaited& each : lane.awaited)
            each.partner = part.partner.empty() ? each.partner : part.partner;
    } else {
        close(lane, now, false);
        lane.since = now;
    }
    if (part.is_input && is_waiting(lane.activity))
        lane.arriving.push_back(part.message);
    else
        lane.here.push_back({part.message, part.is_input});
}

/// Writes the last slice. If the trace ends during a wait, the message that would end the wait arrives at the time of
/// its transfer.
void Timeline::finish(ProgramLane& lane, bool open) {
    close(lane, *end_, open);
    for (const std::uint64_t message : lane.arriving)
        if (const auto found = messages_.find(message); found != messages_.end())
            place({message, true}, lane.track, std::max(found->second.at, lane.since));
}

void Timeline::begin(const Process& process, Time now) {
    if (std::size_t track = tracks_.of(process); track != Tracks::none)
        lanes_.emplace(process.ordinal(), Lane{track, &process, Activity::ready, now});
}

void Timeline::go_on(Lane& lane, Time now) {
    if (is_waiting(lane.activity))
        lane.waited_since = lane.since;
    turn_to(lane, Activity::ready, now);
    for (std::uint64_t message : std::exchange(lane.arriving, {}))
        lane.here.push_back({message, true});
}

void Timeline::compute(Lane& lane, Activity, Time now) {
    if (lane.activity == Activity::computing && lane.stopped == now)
        lane.stopped.reset();
    else if (!is_waiting(lane.activity)) // a processor may work for a waiting process
        turn_to(lane, Activity::computing, now);
    if (std::size_t processor = processor_of(lane); processor != Tracks::none)
        use(processor, tracks_.all()[lane.track].name, now);
}

void Timeline::become_ready(Lane& lane, Time now) {
    if (lane.activity == Activity::computing)
        lane.stopped = now;
    auto use = uses_.find(processor_of(lane));
    if (use != uses_.end() && !use->second.stopped && use->second.subject == tracks_.all()[lane.track].name)
        use->second.stopped = now;
}

void Timeline::end(Lane& lane, Time now) {
    settle(lane, now);
    give_up(lane);
}

std::size_t Timeline::processor_of(const Lane& lane) const {
    const Executive* executive = lane.process->executive();
    return executive ? tracks_.of_place(executive->name()) : Tracks::none;
}

/// Notes a message. If the receiver waits, the message arrives when the receiver continues. For a sender or receiver
/// that does not wait, a new slice begins.
void Timeline::communicated(const AnyChannel& channel, Time now) {
    if (!taking(now) || now < window_.from)
        return;
    Lane *from = lane_of(channel.outputter()), *to = lane_of(channel.inputter());
    if (!from || !to)
        return pass(channel, from, to, now);
    std::uint64_t message = message_count_++;
    messages_.emplace(message, Message{channel.name(), now});
    for (Lane* lane : {from, to})
        if (!is_waiting(lane->activity))
            turn_to(*lane, Activity::ready, now);
    from->here.push_back({message, false});
    from->partner = to->track;
    to->partner = from->track;
    if (is_waiting(to->activity))
        to->arriving.push_back(message);
    else
        to->here.push_back({message, true});
}

/// Notes a message between a process and a booted program. The process has just continued; the program only moves
/// bytes, so it reports no message.
void Timeline::pass(const AnyChannel& channel, Lane* from, Lane* to, Time now) {
    const auto found = program_uses_.find(channel.name());
    if (found == program_uses_.end() || (!from && !to))
        return;
    ProgramUse& use = found->second;
    const std::uint64_t message = message_count_++;
    messages_.emplace(message, Message{channel.name(), now});
    if (to) {
        turn_to(*to, Activity::ready, now);
        to->here.push_back({message, true});
        return place({message, false}, use.track, std::max(use.since, window_.from));
    }
    place({message, false}, from->track, std::max(from->waited_since, window_.from));
    if (use.ended && *use.ended >= from->waited_since)
        place({message, true}, use.track, *use.ended);
    else
        use.arriving.push_back(message);
}

void Timeline::takes(const PlaceTaken& taken, Time now) {
    if (std::size_t track = taking(now) ? tracks_.of_place(taken.place) : Tracks::none; track != Tracks::none)
        use(track, taken.subject, taken.since);
}

void Timeline::leaves(const PlaceLeft& left, Time now) {
    std::size_t track = taking(now) ? tracks_.of_place(left.place) : Tracks::none;
    if (track == Tracks::none)
        return;
    uses_[track].stopped = left.until;
    uses_[track].bytes = left.bytes;
}

void Timeline::over(Time now) {
    if (taking(now))
        shut(now, "");
}

void Timeline::ends_early(Time now, const std::string& why) {
    if (taking(now))
        shut(now, why);
}

void Timeline::turn_to(Lane& lane, Activity activity, Time now) {
    settle(lane, now);
    lane.activity = activity;
    lane.since = now;
    lane.partner = Tracks::none;
}

/// Ends the process's present slice. If the process stopped computing earlier, it has been ready since then.
void Timeline::settle(Lane& lane, Time now) {
    if (std::optional<Time> stopped = std::exchange(lane.stopped, std::nullopt)) {
        close(lane, *stopped);
        lane.activity = Activity::ready;
        lane.since = *stopped;
    }
    close(lane, now);
}

void Timeline::close(Lane& lane, Time end) {
    if (end > window_.from)
        close(lane, slice_of(lane, end, false));
}

/// Writes the slice, and places the ends of messages that belong to it at its beginning. Returns whether the slice is
/// visible.
bool Timeline::close(Lane& lane, Slice slice) {
    Time end = slice.end;
    if (!write(std::move(slice)))
        return false;
    for (const MessageEnd& message : std::exchange(lane.here, {}))
        place(message, lane.track, std::max(lane.since, window_.from));
    lane.last_end = end;
    return true;
}

/// Returns the slice of the present activity, which ends at `end`.
Slice Timeline::slice_of(const Lane& lane, Time end, bool open) const {
    Slice slice{lane.track, lane.activity, lane.since, end, open};
    if (!is_waiting(lane.activity))
        return slice;
    for (const AnyChannel* channel : lane.process->awaited_channels())
        slice.awaited.push_back({channel->name(), partner(lane, *channel, open)});
    slice.awaits_timer = lane.process->awaits_timer();
    return slice;
}

/// Returns the partner of a wait: the process that came to the other end of the channel. If no process has come,
/// returns the last user of this end, or, if this user has ended, its outermost process; "" if unknown.
std::string Timeline::partner(const Lane& lane, const AnyChannel& channel, bool open) const {
    if (lane.partner != Tracks::none)
        return tracks_.all()[lane.partner].name;
    const AnyChannel::User& user =
        lane.activity == Activity::outputting ? channel.last_inputter() : channel.last_outputter();
    if (!user.process)
        return channel.partner_device();
    auto found = lanes_.find(user.ordinal);
    if (found != lanes_.end() && found->second.process == user.process)
        return tracks_.all()[found->second.track].name;
    return user.outermost->path() + (open && user.outermost->ended() ? " (has ended)" : "");
}

void Timeline::use(std::size_t track, const std::string& subject, Time now) {
    Use& present = uses_[track];
    if (present.subject == subject && present.stopped == now && present.bytes == 0) {
        present.stopped.reset();
        return;
    }
    close_use(track, now);
    present = {subject, now};
}

void Timeline::close_use(std::size_t track, Time now) {
    const Use& use = uses_[track];
    if (use.subject.empty())
        return;
    Activity activity = tracks_.all()[track].place.kind == Track::Kind::link ? Activity::carrying : Activity::executing;
    Time end = std::min(use.stopped.value_or(now), now);
    write({track, activity, use.since, end, !use.stopped, use.subject, use.bytes});
}

/// Writes the part of the slice in the window. Returns false if the slice has no such part.
bool Timeline::write(Slice slice) {
    slice.begin = std::max(slice.begin, window_.from);
    if (slice.end < slice.begin || (slice.end == slice.begin && !(slice.open && is_waiting(slice.activity))))
        return false;
    writer_.write(slice);
    ++entries_;
    return true;
}

/// Notes the track and the time of one end of a message. Writes the message when both ends are known.
void Timeline::place(const MessageEnd& end, std::size_t track, Time at) {
    auto found = messages_.find(end.message);
    if (found == messages_.end())
        return;
    Message& message = found->second;
    (end.arrives ? message.to : message.from) = track;
    (end.arrives ? message.arrived : message.left) = at;
    if (message.from == Tracks::none || message.to == Tracks::none)
        return;
    if (message.by_two_clocks)
        message.arrived = std::max(message.arrived, message.left);
    if (message.left <= message.arrived) {
        writer_.write(MessageArrow{message.channel, message.from, message.to, message.left, message.arrived});
        ++entries_;
    }
    messages_.erase(found);
}

/// Places the last messages of a process that has ended, at the end of its last slice. A process without any slice took
/// no time, and its messages cannot be shown.
void Timeline::give_up(Lane& lane) {
    for (const MessageEnd& message : std::exchange(lane.here, {}))
        if (lane.last_end)
            place(message, lane.track, *lane.last_end - Time{1});
        else
            messages_.erase(message.message);
}

/// Ends the trace. Only the end of the run shows whether the present waits will end.
void Timeline::shut(Time now, const std::string& why) {
    end_ = now;
    why_ = why;
    for (auto& [ordinal, lane] : lanes_) {
        if (lane.stopped)
            turn_to(lane, Activity::ready, *lane.stopped);
        lane.last = slice_of(lane, now, true);
        lane.path = lane.process->path();
    }
    for (const auto& [track, use] : uses_)
        close_use(track, now);
}

/// Writes the process's last slice and its remaining messages. REQUIRES: the trace has ended.
void Timeline::finish(Lane& lane, const RunResult& result) {
    lane.last->open = !why_.empty() || never_ends(lane.path, result);
    if (!close(lane, std::move(*lane.last)))
        for (std::uint64_t message : std::exchange(lane.arriving, {}))
            lane.here.push_back({message, true});
    for (std::uint64_t message : lane.arriving)
        if (auto found = messages_.find(message); found != messages_.end())
            place({message, true}, lane.track, std::max(found->second.at, lane.since));
    give_up(lane);
}

} // namespace placedpar
