// These functions handle lost bytes and acknowledges, and messages that a process gives up.

#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

using Phase = LinkState::Phase;
using Ends = LinkState::Ends;

/// Returns whether the packet is lost. If one end has given up the message, its bytes never arrive, but are not counted
/// as losses of a fault. Otherwise the faults of the link decide.
bool LinkDirection::is_lost(LinkStep step) {
    using Message = FaultEffect::Hit::Message;
    const bool acknowledge = step == LinkStep::acknowledge_begins;
    if (!acknowledge && state().directions[number_].ends != Ends::agree)
        return false;
    const AnyChannel::PacketPayload payload = channel_ ? channel_->payload() : AnyChannel::PacketPayload{};
    const std::string& own_name = channel_ ? channel_->name() : name_; // no channel: the ends use give() and take()
    FaultEffect::Hit hit{kernel_.now(), payload.channel ? payload.channel->name() : own_name, acknowledge,
                         bytes_before_part_ + bytes_started() + std::uint64_t{!acknowledge}};
    if (payload.channel)
        hit.message = payload.acknowledges ? Message::acknowledging_packet : Message::packet;
    return faults_->strike(hit, acknowledge != (number_ == 0));
}

/// Returns whether no further byte of the current message will be transferred: a packet was lost, or the receiver gave
/// up the message.
bool LinkDirection::gets_no_further() const {
    const Phase now = phase();
    return now == Phase::byte_lost || now == Phase::acknowledge_lost ||
           (ends() == Ends::receiver_left && now != Phase::travels);
}

bool LinkDirection::input_is_lost(const AnyChannel& channel) const {
    return input_must_be_reset(channel) || (gets_no_further() && bytes_received() > 0);
}

bool LinkDirection::output_must_be_reset(const AnyChannel&) const {
    return has_sender() && state().directions[number_].ends == Ends::receiver_left;
}

bool LinkDirection::input_must_be_reset(const AnyChannel&) const {
    return state().directions[number_].ends == Ends::sender_left;
}

bool LinkDirection::is_sending() const { return counts_ ? counts_->gives : channel_ && channel_->output_waits(); }

/// Returns how many bytes of the current message the receiving end has. If no process waits for a byte, the byte is
/// counted only after its last bit has arrived.
std::uint64_t LinkDirection::bytes_received() const {
    const LinkState::Direction& direction = state().directions[number_];
    const LinkPackets::Stream& stream = state().packets.streams[number_];
    if (direction.ends == Ends::sender_left)
        return bytes_left_over_;
    if (!is_sending() || direction.ends == Ends::receiver_left)
        return 0;
    if (byte_waits())
        return bytes_before_part_ + 1;
    const bool on_its_way = direction.phase == Phase::byte_lost || direction.phase == Phase::unnoticed ||
                            (direction.phase == Phase::owed && !reader_) ||
                            (stream.acknowledge && stream.flows() && kernel_.now() < stream.due);
    return bytes_before_part_ + bytes_started() - std::uint64_t{on_its_way};
}

std::uint64_t LinkDirection::bytes_acknowledged() const {
    if (phase() == Phase::broken_off)
        return acknowledged_when_left_;
    return bytes_before_part_ + bytes_started() - std::uint64_t{state().is_unacknowledged(number_)};
}

/// Drops the scheduled arrivals of bytes of the current part of the message. On a long wire, the last byte of the
/// previous part may still be under way. The arrival of this byte is kept, because the receiver waits for the byte.
void LinkDirection::break_off(LinkCourse::Touch& touch) {
    touch->drop_first_byte(number_);
    const bool last_byte_has_begun = bytes_started() > 0 && touch->packets.streams[number_].bytes_left == 0;
    if (last_byte_has_begun && touch->directions[number_].phase != Phase::byte_lost)
        touch->drop_last_byte(number_);
}

/// Stops the sender in the middle of its message. If the sender has no message, only withdraws the next packet.
void LinkDirection::drop_output(LinkCourse::Touch& touch) {
    LinkState::Direction& direction = touch->directions[number_];
    if (is_sending()) {
        bytes_left_over_ = bytes_received();
        if (bytes_left_over_ > 0)
            direction.ends = Ends::sender_left;
        break_off(touch);
    }
    touch->drop_end_of_sending(number_);
    touch->stop(number_, Phase::idle);
    trace_standstill();
}

bool LinkDirection::give_up_output(AnyChannel& channel) {
    if (!sender_ && !channel.output_waits())
        return false;
    Process* sender = nullptr;
    {
        LinkCourse::Touch touch(course_);
        output_given_up_ = true;
        sent_when_given_up_ = bytes_acknowledged();
        drop_output(touch);
        if (sender_)
            end_part(*touch);
        sender = std::exchange(sender_, nullptr);
    }
    if (writer_)
        writer_->register_ready(); // the adapter's program may be waiting until the register is free
    else if (sender)
        kernel_.make_ready(*sender);
    return true;
}

/// Makes the receiving end leave its message. If a part of the message has arrived, the sender can send no more of it.
void LinkDirection::receiver_leaves(LinkCourse::Touch& touch) {
    LinkState::Direction& direction = touch->directions[number_];
    const bool in_message = bytes_received() > 0;
    if (in_message && direction.ends == Ends::agree) {
        acknowledged_when_left_ = bytes_acknowledged();
        break_off(touch);
        direction.ends = Ends::receiver_left;
        const bool is_between_parts = direction.phase == Phase::idle || touch->expects_end_of_sending(number_);
        if (!is_between_parts && direction.phase != Phase::byte_lost && direction.phase != Phase::acknowledge_lost)
            touch->stop(number_, Phase::broken_off);
        trace_standstill();
    }
    if (in_message) // the last byte of an earlier part may still be on the wire
        touch->drop_last_bytes(number_);
    direction.first_byte = LinkState::FirstByte::asked_for;
}

/// Withdraws the receiver's request for bytes. A byte that is on its way then counts as a byte for which no process
/// waits.
void LinkDirection::forget_asked_byte(LinkCourse::Touch& touch) {
    LinkState::Direction& direction = touch->directions[number_];
    LinkPackets::Stream& stream = touch->packets.streams[number_];
    direction.receiver = LinkState::Receiver::absent;
    const bool unnoticed = direction.phase == Phase::travels && stream.acknowledge && kernel_.now() < stream.due;
    if (!unnoticed)
        return;
    direction.phase = Phase::unnoticed;
    direction.at = std::exchange(stream.due, never);
    if (bytes_started() == 1 && times_.overlaps() && !touch->expects_first_byte(number_))
        touch->expect_first_byte(number_, times_);
}

bool LinkDirection::give_up_input(AnyChannel& channel) {
    if (!channel.input_waits())
        return false;
    Process* receiver = nullptr;
    {
        LinkCourse::Touch touch(course_);
        input_given_up_ = true;
        forget_asked_byte(touch);
        received_when_given_up_ = bytes_received();
        receiver_leaves(touch);
        receiver = std::exchange(receiver_, nullptr);
    }
    if (receiver)
        kernel_.make_ready(*receiver);
    if (reader_)
        reader_->register_ready();
    return true;
}

std::uint64_t LinkDirection::reset_output(AnyChannel&) { return std::exchange(sent_when_given_up_, 0); }

std::uint64_t LinkDirection::reset_input(AnyChannel&) {
    LinkCourse::Touch touch(course_);
    std::uint64_t taken = std::max(std::exchange(received_when_given_up_, 0), bytes_received());
    receiver_leaves(touch);
    if (LinkState::Direction& direction = touch->directions[number_]; direction.ends == Ends::sender_left)
        direction.ends = Ends::agree;
    return taken;
}

} // namespace placedpar::hardware
