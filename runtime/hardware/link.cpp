#include "runtime/hardware/link.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

namespace {

/// Returns the index of the last part that is not empty. Only parts with bytes are sent.
std::size_t last_travelling_part(const WireForm& form) {
    std::size_t part = form.parts() - 1;
    while (part > 0 && form[part] == 0)
        --part;
    return part;
}

const LinkTiming& checked(const LinkTiming& timing, const std::string& end) {
    if (timing.bits_per_second <= 0 || timing.wire_delay < Time{0})
        throw std::logic_error(
            fmt::format("the link at {}: its speed must be positive, and its delay must not be negative", end));
    return timing;
}

} // namespace

Link::Link(Kernel& kernel, const LinkTiming& timing, const std::string& a, const std::string& b)
    : course_(kernel, times_, *this), kernel_(kernel), times_(checked(timing, a)),
      a_to_b_(kernel, a + " -> " + b, times_, course_, 0), b_to_a_(kernel, b + " -> " + a, times_, course_, 1),
      timing_(timing) {}

Process* Link::step_performed(LinkState& state, const LinkState::Next& next, const LinkState::Outcome& outcome) {
    return direction(next.direction).step_performed(state, next.step, outcome);
}

const FaultEffect& Link::suffer(const LinkFault& fault) { return faults().add(fault); }

void Link::lead_through(SwitchPath& passage) { faults().lead_through(passage); }

LinkFaults& Link::faults() {
    if (!faults_) {
        faults_.emplace(timing_.bits_per_second);
        course_.show_faults();
        a_to_b_.suffer(*faults_);
        b_to_a_.suffer(*faults_);
    }
    return *faults_;
}

/// Returns the time until which no packet need be checked for faults. While a fault changes the speed, returns the
/// current time, because every packet must be checked.
Time Link::steady_until() const {
    const bool is_at_speed = faults_->bits_per_second(kernel_.now()) == timing_.bits_per_second;
    return is_at_speed ? faults_->steady_until(kernel_.now()) : kernel_.now();
}

LinkState::Fate Link::packet_begins(const LinkState::Next& next) {
    if (std::int64_t speed = faults_->bits_per_second(kernel_.now()); speed != timing_.bits_per_second) {
        a_to_b_.note_speed();
        b_to_a_.note_speed();
        timing_.bits_per_second = speed;
        times_ = PacketTimes(timing_);
    }
    return direction(next.direction).is_lost(next.step) ? LinkState::Fate::is_lost : LinkState::Fate::comes_over;
}

LinkDirection::LinkDirection(Kernel& kernel, std::string name, const PacketTimes& times, LinkCourse& course,
                             std::size_t number)
    : kernel_(kernel), course_(course), number_(static_cast<std::uint8_t>(number)), times_(times),
      name_(std::move(name)) {}

void LinkDirection::move_messages_of(LinkEngineMemory& memory) {
    if (memories_[1])
        throw std::logic_error(fmt::format("{}: both ends of the link already have a processor", name_));
    memories_[memories_[0] ? 1 : 0] = &memory;
}

void LinkDirection::serve(AnyChannel& channel) {
    if (counts_)
        throw std::logic_error(
            fmt::format("channel {} uses {}, which give() and take() already use", channel.name(), name_));
    if (channel_ && channel_ != &channel)
        throw std::logic_error(fmt::format("channels {} and {} use the same direction of a link: "
                                           "several channels need routers",
                                           channel_->name(), channel.name()));
    channel_ = &channel;
}

bool LinkDirection::Out::begin(Process& self) noexcept {
    if (direction.output_given_up_)
        return false;
    direction.send(self, bytes, last_part);
    self.begin_wait(Activity::outputting, direction.channel_, where);
    return true;
}

bool LinkDirection::In::begin(Process& self) noexcept {
    if (direction.input_given_up_ || direction.receive(self))
        return false;
    self.begin_wait(Activity::inputting, direction.channel_, where);
    return true;
}

void LinkDirection::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    if (form.total() == 0)
        throw std::logic_error("a message without bytes cannot travel on channel " + channel.name());
    begin_writing(channel);
    std::size_t last = last_travelling_part(form);
    Process& self = kernel_.running();
    for (std::size_t part = 0; part <= last && !output_given_up_; ++part)
        if (form[part] > 0) {
            output_.set(form[part], part == last, where);
            charge_and_communicate(self, &OperationCosts::hard_communication, output_);
        }
}

void LinkDirection::input(AnyChannel& channel, const SourceLocation& where) {
    begin_reading(channel);
    Process& self = kernel_.running();
    do {
        input_.where = where;
        charge_and_communicate(self, &OperationCosts::hard_communication, input_);
    } while (!delivered_last_part_ && !input_given_up_);
}

void LinkDirection::begin_writing(AnyChannel& channel) {
    serve(channel);
    output_given_up_ = false;
    if (ends() == LinkState::Ends::receiver_left)
        LinkCourse::Touch(course_)->directions[number_].ends = LinkState::Ends::agree;
    bytes_before_part_ = 0;
}

void LinkDirection::begin_reading(AnyChannel& channel) {
    serve(channel);
    input_given_up_ = false;
}

void LinkDirection::begin_part_of(LinkState& state, std::uint32_t bytes) {
    for (LinkEngineMemory* memory : memories_)
        if (memory)
            ++memory->parts_under_way;
    state.directions[number_].part_bytes = state.packets.streams[number_].bytes_left = bytes;
}

void LinkDirection::end_part(LinkState& state) {
    LinkState::Direction& direction = state.directions[number_];
    LinkPackets::Stream& stream = state.packets.streams[number_];
    for (LinkEngineMemory* memory : memories_)
        if (memory) {
            --memory->parts_under_way;
            memory->words_of_ended_parts += memory->words_in(direction.part_bytes - stream.bytes_left);
        }
    bytes_of_ended_parts_ += direction.part_bytes - stream.bytes_left;
    direction.part_bytes = stream.bytes_left = 0;
}

void LinkDirection::send(Process& sender, std::uint32_t bytes, bool last_part) {
    LinkCourse::Touch touch(course_);
    sender_ = &sender;
    last_part_ = last_part;
    begin_part_of(*touch, bytes);
    touch->ask_for_byte(number_, std::max(touch->may_start(number_), kernel_.now()));
    touch.begin_if_free(number_);
}

/// Begins to receive a part. Returns whether the whole part has arrived already.
bool LinkDirection::receive(Process& receiver) {
    if (course_.waits_idly(number_)) {
        receiver_ = &receiver;
        return false;
    }
    LinkCourse::Touch touch(course_);
    const bool all_here = receiver_asks(touch);
    receiver_ = all_here ? nullptr : &receiver;
    return all_here;
}

/// Asks for a part. Returns whether the whole part has arrived already.
bool LinkDirection::receiver_asks(LinkCourse::Touch& touch) {
    using Phase = LinkState::Phase;
    LinkState::Direction& direction = touch->directions[number_];
    const bool has_come =
        std::exchange(direction.first_byte, LinkState::FirstByte::asked_for) == LinkState::FirstByte::waits;
    const bool all_here =
        has_come && direction.ends != LinkState::Ends::sender_left && touch->packets.streams[number_].bytes_left == 0;
    if (all_here) {
        // If the arrival of the first byte has woken an ALT, the event for the arrival of the last byte may still be
        // scheduled for the current time.
        touch->drop_last_bytes(number_);
        deliver();
    } else {
        direction.receiver = LinkState::Receiver::waits;
    }
    const Phase phase = all_here ? Phase::delivered : Phase::travels;
    if (direction.phase == Phase::owed) {
        touch->ask_for_acknowledge(number_, phase, kernel_.now());
        touch.begin_if_free(number_);
    } else if (direction.phase == Phase::unnoticed) {
        touch->ask_for_acknowledge(number_, phase, direction.at);
    }
    return all_here;
}

/// Hands the message over if its last part has arrived. This happens before the receiving or the sending process
/// continues.
void LinkDirection::deliver() {
    delivered_last_part_ = last_part_;
    if (last_part_)
        channel_->hand_over();
}

void LinkDirection::is_written_by(RegisterUser& user) {
    writer_ = &user;
    LinkCourse::Touch(course_)->users[number_].sender = LinkState::User::program;
}

void LinkDirection::is_read_by(RegisterUser& user) {
    reader_ = &user;
    LinkCourse::Touch(course_)->users[number_].receiver = LinkState::User::program;
}

void LinkDirection::begin_part(AnyChannel& channel, std::uint32_t bytes, bool last_part) {
    serve(channel);
    sender_ = &kernel_.running();
    last_part_ = last_part;
    begin_part_of(*LinkCourse::Touch(course_), bytes);
}

void LinkDirection::write_byte() {
    LinkCourse::Touch touch(course_);
    touch->ask_for_byte(number_, std::max(touch->may_start(number_), kernel_.now()));
    touch.begin_if_free(number_);
}

LinkDirection::Ended LinkDirection::read_byte() {
    using Phase = LinkState::Phase;
    LinkCourse::Touch touch(course_);
    touch->directions[number_].first_byte = LinkState::FirstByte::asked_for;
    const bool ends_part = touch->packets.streams[number_].bytes_left == 0, ends_message = ends_part && last_part_;
    if (ends_part)
        deliver();
    touch->ask_for_acknowledge(number_, ends_part ? Phase::delivered : Phase::travels, kernel_.now());
    touch.begin_if_free(number_);
    return ends_message ? Ended::message : ends_part ? Ended::part : Ended::nothing;
}

Process* LinkDirection::step_performed(LinkState& state, LinkStep step, const LinkState::Outcome& outcome) {
    if (counts_)
        return step_performed_by_counts(state, step, outcome), nullptr;
    if (outcome.delivers)
        deliver();
    switch (step) {
    case LinkStep::byte_begins: return trace_byte(state, outcome), nullptr;
    case LinkStep::acknowledge_begins:
        if (outcome.is_lost)
            trace_standstill();
        return nullptr;
    case LinkStep::byte_is_noticed:
        if (reader_)
            reader_->register_ready();
        if (kernel_.trace() && state.packets.streams[number_].bytes_left > 0)
            trace_break(state.packets.streams[number_].last_start);
        return nullptr;
    case LinkStep::register_is_free: return writer_->register_ready(), nullptr;
    case LinkStep::first_byte_arrives:
        if (!receiver_)
            channel_->announce();
        return nullptr;
    case LinkStep::last_byte_arrives: return outcome.wakes ? std::exchange(receiver_, nullptr) : nullptr;
    case LinkStep::sending_ends: return sending_ended(state);
    case LinkStep::falls_silent: return nullptr;
    }
    return nullptr;
}

Process* LinkDirection::sending_ended(LinkState& state) {
    bytes_before_part_ += state.directions[number_].part_bytes;
    end_part(state);
    Process* sender = std::exchange(sender_, nullptr);
    return writer_ ? nullptr : sender;
}

bool LinkDirection::byte_waits() const { return state().directions[number_].first_byte == LinkState::FirstByte::waits; }

std::uint32_t LinkDirection::bytes_started() const {
    return state().directions[number_].part_bytes - state().packets.streams[number_].bytes_left;
}

std::uint64_t LinkDirection::bytes_carried() const { return bytes_of_ended_parts_ + bytes_started(); }

void LinkDirection::trace_byte(const LinkState& state, const LinkState::Outcome& outcome) {
    if (!kernel_.trace())
        return;
    trace_bytes(kernel_.now());
    if (state.packets.streams[number_].bytes_left == 0 || writer_)
        trace_break(kernel_.now());
    if (outcome.is_lost)
        trace_standstill();
}

/// Begins an interval in the trace, in which the wire carries bytes without a break. A first byte that waits for its
/// acknowledge gets an interval of its own.
void LinkDirection::trace_bytes(Time since) {
    if (course_.trace_carries(number_))
        return;
    course_.trace_knows(number_, true);
    kernel_.trace()->takes({name_, channel_->name(), since, channel_}, kernel_.now());
}

void LinkDirection::trace_break(Time byte_started) {
    course_.trace_knows(number_, false);
    std::uint64_t bytes = bytes_carried() - std::exchange(bytes_traced_, bytes_carried());
    kernel_.trace()->leaves({name_, later(byte_started, times_.byte().carried), bytes}, kernel_.now());
}

/// Ends the interval in the trace, because no byte follows at once.
void LinkDirection::trace_standstill() {
    if (kernel_.trace() && course_.trace_carries(number_))
        trace_break(state().packets.streams[number_].last_start);
}

Time LinkDirection::time_occupied() const {
    auto bytes = static_cast<std::int64_t>(bytes_carried() - bytes_at_old_speed_);
    Time last_start = state().packets.streams[number_].last_start;
    Time end = bytes > 0 ? later(last_start, times_.byte().carried) : old_speed_until_;
    Time to_come = std::max(end, kernel_.now()) - kernel_.now();
    return later(occupied_at_old_speed_, times(bytes, times_.byte().carried)) - to_come;
}

void LinkDirection::note_speed() {
    auto bytes = static_cast<std::int64_t>(bytes_carried() - bytes_at_old_speed_);
    if (bytes == 0)
        return;
    occupied_at_old_speed_ = later(occupied_at_old_speed_, times(bytes, times_.byte().carried));
    old_speed_until_ = later(state().packets.streams[number_].last_start, times_.byte().carried);
    bytes_at_old_speed_ = bytes_carried();
}

} // namespace placedpar::hardware
