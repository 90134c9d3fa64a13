// Messages of which something is lost, and messages that are given up.

#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

/// REQUIRES: the link has faults, and the packet begins now.
bool LinkDirection::is_lost(bool acknowledge) {
    using Message = FaultEffect::Hit::Message;
    const AnyChannel::Cargo& cargo = channel_->cargo();
    FaultEffect::Hit hit{kernel_.now(), cargo.channel ? cargo.channel->name() : channel_->name(), acknowledge,
                         bytes_before_part_ + part_bytes() - part_.bytes_left};
    if (cargo.channel)
        hit.message = cargo.acknowledges ? Message::acknowledging_packet : Message::packet;
    return faults_->take(hit, acknowledge != (number_ == 0));
}

void LinkDirection::stall() {
    stalled_ = true;
    if (kernel_.trace() && trace_carries_)
        trace_break(part_.last_start);
}

/// By the receiving end, of the message under way. A byte for which no process has asked counts when it waits there
/// whole. REQUIRES, here and below: the closed form is not ahead.
std::uint64_t LinkDirection::bytes_taken() const {
    if (left_over_)
        return bytes_left_over_;
    if (!channel_ || !channel_->output_waits() || receiver_left_)
        return 0;
    if (first_byte_waits_)
        return bytes_before_part_ + 1;
    if ((acknowledge_owed_ && !reader_) || waits_for_receiver())
        return bytes_before_part_;
    bool on_its_way = unacknowledged_ && (!byte_comes_over_ || is_unnoticed());
    std::uint32_t started = part_bytes() - part_.bytes_left;
    return bytes_before_part_ + started - (started > 0 && on_its_way);
}

std::uint64_t LinkDirection::bytes_acknowledged() const {
    std::uint32_t started = part_bytes() - part_.bytes_left;
    return bytes_before_part_ + started - (started > 0 && unacknowledged_);
}

/// An engine whose receiver has been given his message may still wait for the arrival of the last byte.
void LinkDirection::withdraw_acknowledge() {
    if (back_.acknowledge_waits(*this))
        back_.withdraw_acknowledge(has_asked_early());
    if (reader_ || !last_byte_is_on_its_way())
        taken_ = false;
}

/// And nothing of the part under way is acknowledged any more. The last byte of the part before may still be on a long
/// wire, and its receiver waits for it.
void LinkDirection::drop_bytes_on_their_way() {
    drop(LinkStep::first_byte_arrives);
    if (part_bytes() > 0 && part_.bytes_left == 0 && byte_comes_over_)
        drop(arrival_of_last());
    withdraw_acknowledge();
    acknowledge_owed_ = readable_ = false;
}

/// The sender stops in the middle of its message, if it is in one.
void LinkDirection::drop_output() {
    if (channel_->output_waits()) {
        bytes_left_over_ = bytes_taken();
        left_over_ = bytes_left_over_ > 0;
        drop_bytes_on_their_way();
    } else {
        withdraw_acknowledge();
    }
    drop(LinkStep::sending_ends);
    out_.withdraw_byte(has_asked_early());
    await_no_more();
    writable_ = true;
    stall();
}

bool LinkDirection::give_up_output(AnyChannel& channel) {
    if (!sender_ && !channel.output_waits())
        return false;
    closed_form_.leave();
    output_given_up_ = true;
    sent_when_given_up_ = bytes_acknowledged();
    drop_output();
    if (sender_) {
        leave_memories();
        Process& sender = *std::exchange(sender_, nullptr);
        if (!writer_)
            kernel_.make_ready(sender);
    }
    agenda_.settle();
    if (writer_)
        writer_->register_ready(); // it may sleep until then
    return true;
}

/// The receiving end is in no message any more. If the sender is in one, it gets no further.
void LinkDirection::receiver_leaves() {
    bool in_message = bytes_taken() > 0;
    if (in_message && !left_over_) {
        drop_bytes_on_their_way();
        out_.withdraw_byte(has_asked_early());
        await_no_more();
        receiver_left_ = true;
        stall();
    }
    if (in_message) { // the end of a part of it may still be on the wire
        for (LinkStep step : arrivals_of_last)
            drop(step);
        taken_ = false;
    }
    first_byte_waits_ = false;
}

bool LinkDirection::give_up_input(AnyChannel& channel) {
    if (!channel.input_waits())
        return false;
    closed_form_.leave();
    input_given_up_ = true;
    take_back_early_acknowledge();
    taken_when_given_up_ = bytes_taken();
    bool first_byte_unnoticed = byte_comes_over_ && is_unnoticed() && part_.bytes_left + 1 == part_bytes();
    if (first_byte_unnoticed && arrives_noticed() && !has(LinkStep::first_byte_arrives))
        enter(LinkStep::first_byte_arrives, arrival(part_.last_start));
    receiver_leaves();
    Process* receiver = std::exchange(receiver_, nullptr);
    agenda_.settle();
    if (receiver)
        kernel_.make_ready(*receiver);
    if (reader_)
        reader_->register_ready();
    return true;
}

std::uint64_t LinkDirection::reset_output(AnyChannel&) { return std::exchange(sent_when_given_up_, 0); }

std::uint64_t LinkDirection::reset_input(AnyChannel&) {
    closed_form_.leave();
    std::uint64_t taken = std::max(std::exchange(taken_when_given_up_, 0), bytes_taken());
    receiver_leaves();
    agenda_.settle();
    left_over_ = false;
    return taken;
}

} // namespace placedpar::hardware
