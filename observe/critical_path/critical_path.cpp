#include "observe/critical_path/critical_path.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <regex>
#include <stdexcept>
#include <string_view>

namespace placedpar {

namespace {

std::string with_executive(const Process& process) {
    std::string name = process.outermost().path();
    return process.executive() ? name + " on " + process.executive()->name() : name;
}

std::string executive_of(const Process& process) { return process.executive() ? process.executive()->name() : ""; }

bool outputs(const Process& process) { return process.activity() == Activity::outputting; }

/// Returns the channel whose message ends the wait. Returns null if no message ends the wait.
const AnyChannel* channel_of_message(const Process& process) {
    const auto channels = process.awaited_channels();
    auto found = std::ranges::find_if(channels, [&](const AnyChannel* channel) {
        return process.activity() != Activity::alternating || channel->message_waits();
    });
    return found == channels.end() ? nullptr : *found;
}

Time sum_of(const std::vector<PathPart>& parts) {
    return std::accumulate(parts.begin(), parts.end(), Time{0},
                           [](Time sum, const PathPart& part) { return sum + (part.end - part.begin); });
}

} // namespace

CriticalPath::CriticalPath(std::size_t most_points) : points_(most_points) {
    add(0, Time{0}, Activity::starting, "", "");
}

std::uint32_t CriticalPath::number_of(const std::string& subject) {
    auto [found, is_new] = numbers_.emplace(subject, static_cast<std::uint32_t>(subjects_.size()));
    if (is_new)
        subjects_.push_back(subject);
    return found->second;
}

/// Adds an event and returns its number. If no time has passed since `before`, adds no event and returns `before`.
CriticalPath::Number CriticalPath::add(Number before, Time at, Activity activity, const std::string& subject,
                                       const std::string& place) {
    if (!points_.empty() && points_[before].at == at)
        return before;
    return points_.add({at, before, activity, number_of(subject), number_of(place)});
}

CriticalPath::Number CriticalPath::add(Number before, Time at, Activity activity, const Process& process) {
    return add(before, at, activity, with_executive(process), executive_of(process));
}

/// Adds the transfer of a message over its link, or on the processor of both processes. The transfer of a packet is a
/// part of the message whose packet it is.
CriticalPath::Number CriticalPath::add_message(Number before, const Lane& lane, const AnyChannel& channel, Time now) {
    auto link = carried_by_.find(&channel);
    const AnyChannel* packets_of = channel.payload().channel;
    return add(before, now, Activity::carrying, (packets_of ? packets_of : &channel)->name(),
               link == carried_by_.end() ? executive_of(*lane.process) : link->second);
}

CriticalPath::Number CriticalPath::later(Number a, Number b) const { return points_[a].at >= points_[b].at ? a : b; }

std::vector<CriticalPath::Number*> CriticalPath::numbers_in_use() {
    std::vector<Number*> numbers{&end_};
    for (auto& [ordinal, lane] : lanes_) {
        numbers.push_back(&lane.last);
        for (std::optional<Number>* number : {&lane.cause, &lane.together})
            if (*number)
                numbers.push_back(&**number);
    }
    auto add_all = [&](auto& by_key) {
        for (auto& [key, number] : by_key)
            numbers.push_back(&number);
    };
    add_all(held_);
    add_all(bus_held_);
    add_all(came_);
    return numbers;
}

/// Removes points that are no longer needed. The end of a turn on a processor's scheduler (executive) cannot cause
/// events later than its own time.
void CriticalPath::forget(Time now) {
    if (!points_.should_forget())
        return;
    std::erase_if(held_, [&](const auto& held) { return points_[held.second].at < now; });
    points_.forget_but(numbers_in_use());
}

void CriticalPath::turn(Lane& lane, Activity to, Time now) {
    if (!lane.process->serves_machine())
        accounts_.turn(lane.process->outermost().name(), lane.does, to, now);
    lane.does = to;
}

void CriticalPath::turns(const Process& process, Activity activity, Time now) {
    forget(now);
    tell(process, activity, now);
}

/// Updates the account of a booted program's process. A message of such a process takes no time once both processes are
/// at the channel.
void CriticalPath::program_turns(const ProgramTurn& turn, Time now) {
    ProgramLane& lane = programs_[turn.process];
    if (is_waiting(lane.does) && turn.activity == Activity::ready)
        accounts_.explain(turn.process, turn.partner.empty() ? lane.partner : turn.partner, now, now);
    accounts_.turn(turn.process, lane.does, turn.activity, now);
    lane = {turn.activity, turn.awaited.empty() ? "" : turn.awaited.front().partner};
}

/// Adds a process. A component of a PAR begins at its parent's last event.
void CriticalPath::begin(const Process& process, Time now) {
    Lane* parent = lane_of(process.parent());
    Lane lane{add(parent ? parent->last : 0, now, Activity::starting, process), &process};
    turn(lanes_.emplace(process.ordinal(), lane).first->second, Activity::ready, now);
}

/// Returns the event that gave the process its turn: the end of its wait, the end of the preceding turn on its
/// processor, or a new event for the time in which the process was ready.
CriticalPath::Number CriticalPath::turn_of(const Lane& lane, Number made_ready, Time now) {
    if (points_[made_ready].at == now)
        return made_ready;
    auto held = held_.find(lane.process->executive());
    if (held != held_.end() && points_[held->second].at == now)
        return held->second;
    return add(made_ready, now, Activity::ready, *lane.process);
}

void CriticalPath::has_turn(Lane& lane, Time now) {
    lane.last = turn_of(lane, lane.cause.value_or(lane.last), now);
    lane.cause.reset();
}

void CriticalPath::compute(Lane& lane, Activity activity, Time now) {
    has_turn(lane, now);
    turn(lane, activity, now);
}

void CriticalPath::hold_executive(const Lane& lane) {
    if (const Executive* executive = lane.process->executive())
        held_[executive] = lane.last;
}

void CriticalPath::wait(Lane& lane, Activity activity, Time now) {
    has_turn(lane, now);
    hold_executive(lane);
    lane.together.reset();
    turn(lane, activity, now);
    if (activity == Activity::outputting || activity == Activity::inputting)
        for (const AnyChannel* channel : lane.process->awaited_channels())
            came_[{channel, activity == Activity::outputting}] = lane.last;
}

/// Notes the event with which both processes are at the channel: the later of their last events.
void CriticalPath::communicated(const AnyChannel& channel, Time) {
    Lane *from = lane_of(channel.outputter()), *to = lane_of(channel.inputter());
    if (!from || !to)
        return;
    from->together = to->together = later(from->last, to->last);
    if (auto link = carried_by_.find(&channel); link != carried_by_.end())
        waits_at_links_[link->second] += points_[*from->together].at - points_[from->last].at;
}

void CriticalPath::takes(const PlaceTaken& taken, Time) {
    if (taken.channel) {
        carried_by_[taken.channel] = taken.place;
        carried_since_[taken.channel] = taken.since;
    }
}

/// Returns the process whose program is running now; null while the kernel handles an event.
const CriticalPath::Lane* CriticalPath::who_runs(const Process& any, Time now) {
    const Lane* lane = lane_of(any.kernel().who_runs());
    bool runs = lane && lane->does == Activity::ready && !lane->cause && points_[lane->last].at == now;
    return runs ? lane : nullptr;
}

/// Returns the event that ends a message. A message over a link ends by itself. Other messages end when another process
/// acts: the partner in a soft channel, or a router with a packet.
CriticalPath::Number CriticalPath::message_over(const Lane& lane, const AnyChannel& channel, Time now) {
    if (lane.together && carried_by_.contains(&channel))
        return add_message(*lane.together, lane, channel, now);
    if (const Lane* other = who_runs(*lane.process, now))
        return other->last;
    if (lane.together)
        return add_message(*lane.together, lane, channel, now);
    auto came = came_.find({&channel, !outputs(*lane.process)});
    return add_message(came == came_.end() ? lane.last : later(lane.last, came->second), lane, channel, now);
}

CriticalPath::Number CriticalPath::cause_of(const Lane& lane, Time now) {
    const Process& process = *lane.process;
    if (const AnyChannel* channel = channel_of_message(process))
        return message_over(lane, *channel, now);
    if (const Lane* other = process.serves_machine() ? who_runs(process, now) : nullptr)
        return other->last; // the other process gives this router a packet to send
    return add(lane.last, now, Activity::delayed, process);
}

/// Adds a finished wait to the process's account, with the partner and the time since both processes were at the
/// channel.
void CriticalPath::explain_wait(const Lane& lane, Time now) {
    const Process& process = *lane.process;
    if (process.serves_machine())
        return;
    std::string partner;
    Time together = now;
    if (const AnyChannel* channel = channel_of_message(process)) {
        const AnyChannel::User& user = outputs(process) ? channel->last_inputter() : channel->last_outputter();
        const std::string device = user.outermost ? "" : channel->partner_device();
        partner = user.outermost ? user.outermost->name() : device.empty() ? channel->name() : device;
        if (const Point& cause = points_[*lane.cause]; lane.together)
            together = points_[*lane.together].at;
        else if (!device.empty()) // a device's bytes flow as soon as both processes are at the channel
            together = std::max(points_[lane.last].at, carried_since_[channel]);
        else if (cause.activity == Activity::carrying && cause.at == now)
            together = points_[cause.before].at;
    }
    accounts_.explain(process.outermost().name(), partner, together, now);
}

/// Handles the end of a wait or of a computation.
void CriticalPath::become_ready(Lane& lane, Time now) {
    if (is_waiting(lane.does) && !lane.cause) {
        lane.cause = cause_of(lane, now);
        explain_wait(lane, now);
        turn(lane, Activity::ready, now);
    } else if (lane.does == Activity::computing || lane.does == Activity::moving) {
        lane.last = add(lane.last, now, Activity::computing, *lane.process);
        hold_executive(lane);
        turn(lane, Activity::ready, now);
    }
}

void CriticalPath::go_on(Lane& lane, Time now) {
    if (is_waiting(lane.does))
        become_ready(lane, now);
    if (is_waiting(lane.does)) // the process waited for the end of its PAR
        turn(lane, Activity::ready, now);
    has_turn(lane, now);
}

/// Adds a transfer over a bus. Before the transfer, the path leads over the bus's preceding use if this use ended later
/// than the process's last event.
void CriticalPath::leaves(const PlaceLeft& left, Time now) {
    Lane* lane = lane_of(left.moves_for);
    if (!lane)
        return;
    const std::string& bus = left.place;
    auto held = bus_held_.find(bus);
    Number before = held == bus_held_.end() ? lane->last : later(lane->last, held->second);
    lane->last = add(add(before, left.since, Activity::arbitrating, bus, bus), now, Activity::moving,
                     fmt::format("{} over {}", with_executive(*left.moves_for), bus), bus);
    bus_held_[bus] = lane->last;
}

/// Handles the end of a process. The component of a PAR that ends last causes the parent to continue.
void CriticalPath::end(Lane& lane, Time now) {
    has_turn(lane, now);
    hold_executive(lane);
    turn(lane, Activity::ended, now);
    end_ = later(lane.last, end_);
    const Process& process = *lane.process;
    if (Lane* parent = lane_of(process.parent()))
        parent->cause = lane.last;
}

/// Ends the path. If the run did not end with the end of a process, the path leads to the last event of any process.
void CriticalPath::over(Time now) {
    for (auto& [ordinal, lane] : lanes_)
        if (lane.does == Activity::computing)
            lane.last = add(lane.last, now, Activity::computing, *lane.process);
    for (const auto& [ordinal, lane] : lanes_)
        if (points_[lane.last].at > points_[end_].at)
            end_ = lane.last;
    end_ = add(end_, now, Activity::ended, "", "");
    accounts_.close(now);
    over_ = now;
}

std::vector<PathPart> CriticalPath::parts() const {
    std::vector<PathPart> parts;
    if (too_long())
        return parts;
    for (Number number = end_; number != 0; number = points_[number].before) {
        const Point& point = points_[number];
        const std::string& subject = subjects_[point.subject];
        if (!parts.empty() && parts.back().activity == point.activity && parts.back().subject == subject)
            parts.back().begin = points_[point.before].at;
        else
            parts.push_back({point.activity, subject, subjects_[point.place], points_[point.before].at, point.at});
    }
    std::ranges::reverse(parts);
    if (sum_of(parts) != over_)
        throw std::logic_error(fmt::format("the parts of the critical path add up to {} ps, but the run lasts {} ps",
                                           sum_of(parts).count(), over_.count()));
    return parts;
}

namespace {

/// Returns "master[].out[] -> slave[][].in" for "master[1].out[0] -> slave[1][0].in".
std::string with_empty_subscripts(const std::string& subject) {
    static const std::regex subscript(R"(\[\d+\])");
    return std::regex_replace(subject, subscript, "[]");
}

/// Returns the activity's rank, which orders equal shares.
std::size_t rank_of(Activity activity) {
    constexpr Activity ranked[] = {Activity::starting,    Activity::computing, Activity::carrying, Activity::moving,
                                   Activity::arbitrating, Activity::delayed,   Activity::ready,    Activity::ended};
    return static_cast<std::size_t>(std::ranges::find(ranked, activity) - ranked);
}

template <class Name>
std::vector<PathShare> as_shares(const std::map<std::pair<Activity, Name>, Time>& times) {
    std::vector<PathShare> shares;
    for (const auto& [what, time] : times)
        shares.push_back({what.first, std::string(what.second), time});
    std::ranges::stable_sort(shares, {},
                             [](const PathShare& share) { return std::pair(-share.time, rank_of(share.activity)); });
    return shares;
}

} // namespace

std::vector<PathShare> shares_by_activity(const std::vector<PathPart>& parts) {
    std::map<std::pair<Activity, std::string_view>, Time> times;
    for (const PathPart& part : parts)
        times[{part.activity, ""}] += part.end - part.begin;
    return as_shares(times);
}

std::string name_of(const PathShare& share) { return name_on_path(share.activity, share.subject); }

std::vector<PathShare> shares_of(const std::vector<PathPart>& parts) {
    std::map<std::pair<Activity, std::string_view>, Time> times;
    for (const PathPart& part : parts)
        times[{part.activity, part.subject}] += part.end - part.begin;
    return as_shares(times);
}

std::vector<PathShare> shares_by_array(const std::vector<PathPart>& parts) {
    std::map<std::pair<Activity, std::string>, Time> times;
    for (const PathShare& share : shares_of(parts))
        times[{share.activity, with_empty_subscripts(share.subject)}] += share.time;
    return as_shares(times);
}

} // namespace placedpar
