#include "runtime/hardware/link.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

namespace {

/// The last part of a message that is not empty: empty parts do not travel.
std::size_t last_travelling_part(const WireForm& form) {
    std::size_t part = form.parts() - 1;
    while (part > 0 && form[part] == 0)
        --part;
    return part;
}

const LinkTiming& checked(const LinkTiming& timing, const std::string& end) {
    if (timing.bits_per_second <= 0 || timing.wire_delay < Time{0})
        throw std::logic_error(
            fmt::format("the link at {}: its speed must be positive and its delay not negative", end));
    return timing;
}

} // namespace

Link::Link(Kernel& kernel, const LinkTiming& timing, const std::string& a, const std::string& b)
    : agenda_(kernel, *this), closed_form_(kernel, times_, a_to_b_, b_to_a_), kernel_(kernel),
      times_(checked(timing, a)), wire_from_a_(kernel, agenda_, times_, 0), wire_from_b_(kernel, agenda_, times_, 1),
      a_to_b_(kernel, a + " -> " + b, times_, wire_from_a_, wire_from_b_, agenda_, closed_form_, 0),
      b_to_a_(kernel, b + " -> " + a, times_, wire_from_b_, wire_from_a_, agenda_, closed_form_, 1), timing_(timing) {}

void Link::take(LinkStep step, std::size_t direction) {
    if (step == LinkStep::wire_is_free)
        (direction == 0 ? wire_from_a_ : wire_from_b_).serve();
    else
        (direction == 0 ? a_to_b_ : b_to_a_).take(step);
}

void Link::plan() {
    a_to_b_.plan();
    b_to_a_.plan();
    wire_from_a_.plan();
    wire_from_b_.plan();
}

const FaultEffect& Link::suffer(const LinkFault& fault) { return faults().add(fault); }

void Link::lead_through(Passage& passage) { faults().lead_through(passage); }

LinkFaults& Link::faults() {
    if (!faults_) {
        faults_.emplace(timing_.bits_per_second);
        a_to_b_.suffer(*faults_);
        b_to_a_.suffer(*faults_);
        wire_from_a_.watch(*this);
        wire_from_b_.watch(*this);
    }
    return *faults_;
}

void Link::packet_begins() {
    std::int64_t speed = faults_->bits_per_second(kernel_.now());
    if (speed == timing_.bits_per_second)
        return;
    a_to_b_.note_speed();
    b_to_a_.note_speed();
    timing_.bits_per_second = speed;
    times_ = PacketTimes(timing_);
}

LinkDirection::LinkDirection(Kernel& kernel, std::string name, const PacketTimes& times, Wire& out, Wire& back,
                             LinkAgenda& agenda, ClosedForm& closed_form, std::size_t number)
    : kernel_(kernel), closed_form_(closed_form), agenda_(agenda), part_(closed_form.part(number)), out_(out),
      back_(back), number_(static_cast<std::uint8_t>(number)), times_(times), name_(std::move(name)) {}

void LinkDirection::move_messages_of(MemoryOfEngines& memory) {
    if (memories_[1])
        throw std::logic_error(fmt::format("{}: a link has two ends, which have a processor each already", name_));
    memories_[memories_[0] ? 1 : 0] = &memory;
}

void LinkDirection::take(LinkStep step) {
    switch (step) {
    case LinkStep::acknowledge_is_due: return acknowledge_is_due();
    case LinkStep::wire_is_free: return; // not its own
    case LinkStep::byte_is_due: return byte_is_due();
    case LinkStep::first_byte_arrives: return first_byte_arrived();
    case LinkStep::last_byte_arrives:
    case LinkStep::later_last_byte_arrives: return last_byte_arrived();
    case LinkStep::sending_ends: return sending_ended();
    }
}

void LinkDirection::serve(AnyChannel& channel) {
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
    } while (!took_last_part_ && !input_given_up_);
}

void LinkDirection::send(Process& sender, std::uint32_t bytes, bool last_part) {
    sender_ = &sender;
    enter_memories(bytes);
    last_part_ = last_part;
    stalled_ = false;
    closed_form_.leave();
    if (kernel_.now() >= may_start_)
        start_byte();
    else
        await(Packet::byte, may_start_);
    agenda_.settle();
}

/// Returns whether the part is there already: then it is taken.
bool LinkDirection::receive(Process& receiver) {
    bool was_waited_for = waits_for_receiver();
    receiver_ = &receiver;
    bool all_here = std::exchange(first_byte_waits_, false) && !left_over_ && progress().bytes_left == 0;
    bool noticed_before = was_waited_for && next_due_ <= kernel_.now();
    bool owed = std::exchange(acknowledge_owed_, false) || noticed_before;
    if (owed || was_waited_for) {
        closed_form_.leave();
        if (noticed_before)
            await_none();
        if (owed)
            back_.ask_for_acknowledge(*this);
    }
    if (all_here)
        for (LinkStep step : arrivals_of_last)
            drop(step); // of this moment, if the arrival of the first byte woke an alternation
    if (owed || was_waited_for || all_here)
        agenda_.settle();
    if (all_here) {
        take_part();
        receiver_ = nullptr;
    }
    return all_here;
}

/// A part ends when both its last byte has arrived and that byte's acknowledge has started; this is called at each. The
/// message is delivered at the earlier of the two, so that neither process goes on before it.
void LinkDirection::take_part() {
    taken_ = !taken_;
    if (!taken_)
        return;
    took_last_part_ = last_part_;
    if (last_part_)
        channel_->hand_over();
}

void LinkDirection::begin_writing(AnyChannel& channel) {
    serve(channel);
    output_given_up_ = receiver_left_ = false;
    bytes_before_part_ = 0;
}

void LinkDirection::begin_reading(AnyChannel& channel) {
    serve(channel);
    input_given_up_ = false;
}

void LinkDirection::begin_part(AnyChannel& channel, std::uint32_t bytes, bool last_part) {
    serve(channel);
    sender_ = &kernel_.running();
    enter_memories(bytes);
    last_part_ = last_part;
    stalled_ = false;
}

void LinkDirection::write_byte() {
    writable_ = false;
    out_.ask_for_byte(*this);
    agenda_.settle();
}

void LinkDirection::may_be_written() {
    writable_ = true;
    writer_->register_ready();
}

LinkDirection::Ended LinkDirection::read_byte() {
    readable_ = acknowledge_owed_ = first_byte_waits_ = false;
    bool ends_part = part_.bytes_left == 0, ends_message = ends_part && last_part_;
    if (ends_part)
        take_part();
    back_.ask_for_acknowledge(*this);
    agenda_.settle();
    return ends_message ? Ended::message : ends_part ? Ended::part : Ended::nothing;
}

void LinkDirection::await(Packet packet, Time due) {
    next_ = packet;
    next_due_ = due;
}

/// A packet whose wire is busy beyond that moment needs no step of its own: it can ask for the wire at once.
void LinkDirection::ask_early() {
    if (every_byte_)
        return;
    if (next_ == Packet::byte && next_due_ < out_.free_at()) {
        await_none();
        out_.ask_for_byte(*this);
    } else if (next_ == Packet::acknowledge && receiver_takes_byte() && next_due_ < back_.free_at()) {
        await_none();
        back_.ask_for_acknowledge(*this);
    }
}

/// The receiver will not take the byte after all.
void LinkDirection::take_back_early_acknowledge() {
    if (byte_comes_over_ && is_unnoticed() && back_.acknowledge_waits(*this)) {
        back_.withdraw_acknowledge(true);
        await(Packet::acknowledge, next_due_);
    }
}

void LinkDirection::plan() {
    ask_early();
    if (next_ == Packet::byte)
        enter(LinkStep::byte_is_due, next_due_);
    else
        drop(LinkStep::byte_is_due);
    if (next_ == Packet::acknowledge && !waits_for_receiver())
        enter(LinkStep::acknowledge_is_due, next_due_);
    else
        drop(LinkStep::acknowledge_is_due);
}

void LinkDirection::byte_is_due() {
    await_none();
    start_byte();
}

void LinkDirection::start_byte() {
    if (writer_)
        return may_be_written();
    out_.ask_for_byte(*this);
}

void LinkDirection::byte_started() {
    ++bytes_carried_;
    --part_.bytes_left;
    part_.last_start = kernel_.now();
    unacknowledged_ = true;
    byte_comes_over_ = !left_over_ && !receiver_left_ && !(faults_ && is_lost(false));
    if (byte_comes_over_)
        foresee_arrival();
    if (kernel_.trace()) {
        trace_bytes(kernel_.now());
        if (part_.bytes_left == 0 || writer_)
            trace_break(kernel_.now());
    }
    if (!byte_comes_over_)
        stall();
    closed_form_.look_ahead();
}

/// Of the byte that starts now.
void LinkDirection::foresee_arrival() {
    Time now = kernel_.now();
    await(Packet::acknowledge, later(now, times_.byte().to_answer));
    if (part_.bytes_left + 1 == part_bytes())
        foresee_arrival_of_first();
    if (part_.bytes_left == 0)
        foresee_arrival_of_last(now);
}

/// Where a process waits for it, that makes no difference to anybody, unless it leaves before it is noticed.
void LinkDirection::foresee_arrival_of_first() {
    bool waited_for = receiver_ && !last_byte_is_on_its_way();
    if (every_byte_ || !waited_for || !arrives_noticed())
        enter(LinkStep::first_byte_arrives, arrival(part_.last_start));
    else
        drop(LinkStep::first_byte_arrives); // of the part before, which was taken: it would change nothing
}

void LinkDirection::foresee_arrival_of_last(Time started) {
    last_of_part_ = has(arrivals_of_last[0]);
    enter(arrival_of_last(), arrival(started));
}

/// The byte is noticed.
void LinkDirection::acknowledge_is_due() {
    await_none();
    if (reader_) {
        readable_ = acknowledge_owed_ = true;
        reader_->register_ready();
    } else if (receiver_ || taken_)
        back_.ask_for_acknowledge(*this);
    else
        acknowledge_owed_ = true;
    if (kernel_.trace() && acknowledge_owed_ && part_.bytes_left > 0)
        trace_break(part_.last_start);
}

void LinkDirection::first_byte_arrived() {
    if (!receiver_) {
        first_byte_waits_ = true;
        channel_->announce();
    }
}

void LinkDirection::last_byte_arrived() {
    if (receiver_) {
        take_part();
        kernel_.make_ready(*std::exchange(receiver_, nullptr));
    }
}

void LinkDirection::acknowledge_started() {
    if (faults_ && is_lost(true)) {
        if (part_.bytes_left == 0)
            take_part();
        return stall();
    }
    unacknowledged_ = false;
    may_start_ = later(kernel_.now(), times_.acknowledge().to_answer);
    if (part_.bytes_left == 0) {
        take_part();
        enter(LinkStep::sending_ends, later(kernel_.now(), times_.wire_delay + times_.acknowledge().carried));
    } else {
        await(Packet::byte, may_start_);
    }
    closed_form_.look_ahead();
}

/// Bytes follow each other without a break from the first of a part to the last, except that the first may have to wait
/// for its acknowledge.
void LinkDirection::trace_bytes(Time since) {
    if (!std::exchange(trace_carries_, true))
        kernel_.trace()->takes({name_, channel_->name(), since, channel_}, kernel_.now());
}

void LinkDirection::trace_break(Time byte_started) {
    trace_carries_ = false;
    std::uint64_t bytes = bytes_carried_ - std::exchange(bytes_traced_, bytes_carried_);
    kernel_.trace()->leaves({name_, later(byte_started, times_.byte().carried), bytes}, kernel_.now());
}

Time LinkDirection::time_occupied() const {
    auto bytes = static_cast<std::int64_t>(bytes_carried() - bytes_at_old_speed_);
    Time end = bytes > 0 ? later(progress().last_start, times_.byte().carried) : old_speed_until_;
    Time to_come = std::max(end, kernel_.now()) - kernel_.now();
    return later(occupied_at_old_speed_, times(bytes, times_.byte().carried)) - to_come;
}

/// REQUIRES: the closed form is not ahead.
void LinkDirection::note_speed() {
    auto bytes = static_cast<std::int64_t>(bytes_carried() - bytes_at_old_speed_);
    if (bytes == 0)
        return;
    occupied_at_old_speed_ = later(occupied_at_old_speed_, times(bytes, times_.byte().carried));
    old_speed_until_ = later(part_.last_start, times_.byte().carried);
    bytes_at_old_speed_ = bytes_carried();
}

void LinkDirection::sending_ended() {
    bytes_before_part_ += part_bytes();
    leave_memories();
    Process& sender = *std::exchange(sender_, nullptr);
    if (!writer_)
        return kernel_.make_ready(sender);
    await(Packet::byte, std::max(may_start_, kernel_.now()));
    plan();
}

void LinkDirection::enter_memories(std::uint32_t bytes) {
    for (MemoryOfEngines* memory : memories_)
        if (memory)
            ++memory->parts_under_way;
    part_bytes() = part_.bytes_left = bytes;
}

void LinkDirection::leave_memories() {
    for (MemoryOfEngines* memory : memories_)
        if (memory) {
            --memory->parts_under_way;
            memory->words_of_ended_parts += memory->words_in(part_bytes() - part_.bytes_left);
        }
    part_bytes() = part_.bytes_left = 0;
}

} // namespace placedpar::hardware
