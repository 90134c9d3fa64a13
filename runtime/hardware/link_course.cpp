#include "runtime/hardware/link_course.hpp"

#include "runtime/kernel.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

namespace {

constexpr Time end_of_time = Time::max() - std::chrono::hours{1}; // packets that begin later are computed one by one

bool begins_packet(LinkStep step) { return step == LinkStep::byte_begins || step == LinkStep::acknowledge_begins; }

} // namespace

LinkCourse::LinkCourse(Kernel& kernel, const PacketTimes& times, LinkObserver& observer)
    : first_rank_(kernel.new_ranks(LinkState::ranks)), kernel_(kernel), times_(times), observer_(observer) {
    state_ = &states_[0];
    ahead_ = &states_[1];
}

/// Prefetches the states of the link, because in a large machine they are rarely in a fast cache.
void LinkCourse::fetch_states() const {
    constexpr std::size_t line = 64;
    const char* first = reinterpret_cast<const char*>(states_.data());
    for (std::size_t at = 0; at < sizeof states_; at += line)
        __builtin_prefetch(first + at, 1);
}

void LinkCourse::Touch::begin_if_free(std::size_t direction) {
    LinkState::Next next = course_.state_->next_packet(direction);
    if (next.at <= course_.kernel_.now())
        course_.perform(next);
}

/// Performs a step, and reports it to the observer. If a packet begins that a fault may affect, first asks the observer
/// whether the packet is lost.
Process* LinkCourse::perform(const LinkState::Next& next) {
    LinkState::Fate fate = state_->may_lose_packets && begins_packet(next.step) ? observer_.packet_begins(next)
                                                                                : LinkState::Fate::comes_over;
    LinkState::Outcome outcome = state_->perform(next, times_, fate);
    return observer_.step_performed(*state_, next, outcome);
}

void LinkCourse::happen() noexcept {
    fetch_states();
    if (where_next_ == Ahead::after_others)
        std::swap(state_, ahead_);
    forget_run();
    Process* woken = perform(next_);
    look_ahead();
    if (woken)
        kernel_.make_ready(*woken);
}

bool LinkCourse::is_still() const {
    const auto& streams = state_->packets.streams; // up to date, because no step will happen
    return !scheduled() && std::max(streams[0].last_start, streams[1].last_start) < kernel_.now();
}

const LinkState& LinkCourse::state() {
    catch_up(kernel_.now());
    return *state_;
}

bool LinkCourse::waits_idly(std::size_t direction) {
    const LinkState::Direction& now = state().directions[direction];
    if (now.phase != LinkState::Phase::idle || now.first_byte == LinkState::FirstByte::waits)
        return false;
    for (LinkState& each : states_)
        each.directions[direction].receiver = LinkState::Receiver::waits;
    return true;
}

/// Performs the steps up to `now`, which are all invisible.
void LinkCourse::perform_steps_until(Time now) {
    if (runs_from_ <= now) {
        if (state_->packets.now < runs_from_)
            perform_unseen_steps(runs_from_);
        const std::array<std::uint32_t, 2> before = state_->bytes_left();
        period_.replay(
            state_->packets, times_,
            {.before = later(std::min(now, runs_until_), Time{1}), .last_bytes_stop = kernel_.trace() != nullptr});
        state_->note_last_bytes(before, times_);
    }
    perform_unseen_steps(now);
}

void LinkCourse::perform_unseen_steps(Time until) {
    LinkState::Next next = state_->next();
    for (; next.at <= until && !is_visible(*state_, next); next = state_->next())
        state_->perform(next, times_);
    quiet_until_ = next.at;
}

void LinkCourse::catch_up_and_stay() {
    fetch_states();
    catch_up(kernel_.now());
    state_->packets.now = kernel_.now();
    forget_run();
    quiet_until_ = later(kernel_.now(), Time{1});
}

void LinkCourse::look_ahead() {
    forget_run();
    if (state_->may_lose_packets)
        steady_until_ = observer_.steady_until();
    for (std::size_t direction : {0u, 1u})
        period_.part_bytes[direction] = state_->directions[direction].part_bytes;
    const LinkState::Next next = state_->next();
    quiet_until_ = next.at;
    if (next.at == never) {
        kernel_.future().cancel(*this);
    } else if (is_visible(*state_, next)) {
        where_next_ = Ahead::at_once;
        schedule(next);
    } else {
        run_ahead(next);
    }
}

/// Runs a copy of the state ahead to the next visible step. If no visible step follows, schedules the last step, after
/// which the link is silent. REQUIRES: the next step of the state itself is invisible.
void LinkCourse::run_ahead(LinkState::Next next) {
    *ahead_ = *state_;
    where_next_ = Ahead::after_others;
    do {
        if (!begins_packet(next.step) || !run_packets(next.at))
            ahead_->perform(next, times_);
        next = ahead_->next();
    } while (next.at != never && !is_visible(*ahead_, next));
    if (next.at == never)
        next.at = ahead_->packets.now;
    schedule(next);
}

/// Returns a time up to which many packets of the copy can be computed together. Up to this time, packets change only
/// times and numbers of bytes.
Time LinkCourse::runs_before() const {
    Time before = std::min({end_of_time, steady_until_, ahead_->arrivals[ahead_->first_arrival()]});
    for (std::size_t direction : {0u, 1u}) {
        const LinkPackets::Stream& stream = ahead_->packets.streams[direction];
        if (kernel_.trace() && !trace_carries_[direction] && stream.bytes_left > 0 && stream.flows())
            return Time{};
        before = std::min(before, ahead_->runs_before(direction, times_));
    }
    return before;
}

/// Computes many packets of the copy together; the first begins at `from`. Returns whether any packet has begun. Does
/// nothing if only one packet can be computed, or if a period is already stored, because catch_up() still needs that
/// period.
bool LinkCourse::run_packets(Time from) {
    if (period_.since != never)
        return false;
    const LinkLimit limit{.before = runs_before(), .last_bytes_stop = kernel_.trace() != nullptr};
    if (from >= limit.before)
        return false;
    const std::array<std::uint32_t, 2> bytes_left_before = ahead_->bytes_left();
    const Time now = ahead_->packets.now;
    if (!period_.find(ahead_->packets, times_, limit))
        return false;
    runs_from_ = now;
    runs_until_ = ahead_->packets.now;
    ahead_->note_last_bytes(bytes_left_before, times_);
    return true;
}

void LinkCourse::schedule(const LinkState::Next& next) {
    EventQueue& future = kernel_.future();
    if (scheduled() && next.at == next_.at && next.order == next_.order) {
        next_ = next;
        return;
    }
    next_ = next;
    const Time at = next.at == too_late ? Time::max() : next.at; // the run fails at an event at Time::max()
    future.reschedule(*this, at, next.priority(), first_rank_ + next.rank());
}

bool LinkCourse::is_visible(const LinkState& state, const LinkState::Next& next) const {
    using Phase = LinkState::Phase;
    if (next.at >= every_step_from_)
        return true;
    const LinkState::Direction& direction = state.directions[next.direction];
    switch (next.step) {
    case LinkStep::byte_begins: return next.at >= steady_until_ || trace_sees_byte(state, next.direction);
    case LinkStep::acknowledge_begins:
        return next.at >= steady_until_ ||
               (state.packets.streams[next.direction].bytes_left == 0 && direction.phase != Phase::delivered);
    case LinkStep::byte_is_noticed:
        return state.users[next.direction].receiver == LinkState::User::program ||
               (kernel_.trace() && state.packets.streams[next.direction].bytes_left > 0);
    case LinkStep::first_byte_arrives: return direction.receiver == LinkState::Receiver::absent;
    case LinkStep::last_byte_arrives: return direction.receiver == LinkState::Receiver::waits;
    case LinkStep::register_is_free:
    case LinkStep::sending_ends:
    case LinkStep::falls_silent: return true;
    }
    return true;
}

bool LinkCourse::trace_sees_byte(const LinkState& state, std::size_t d) const {
    const LinkState::Direction& direction = state.directions[d];
    return kernel_.trace() &&
           (!trace_carries_[d] || state.packets.streams[d].bytes_left == 1 ||
            state.users[d].sender == LinkState::User::program || direction.ends != LinkState::Ends::agree);
}

} // namespace placedpar::hardware
