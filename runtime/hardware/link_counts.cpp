// These functions are for ends that state only how many bytes they send (give()) or receive (take()), such as those of
// emulated transputers. The two numbers, the counts, may differ.
//
// The bytes travel in parts. The length of a part is the smaller count. If one end has bytes left when a part ends, the
// next part begins as soon as the other end states a new count.

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

using Phase = LinkState::Phase;

void LinkDirection::move_by_counts(ByteUser& sender, ByteUser& receiver) {
    if (channel_ || writer_ || reader_)
        throw std::logic_error(
            fmt::format("{} carries messages already, so give() and take() cannot be used on it", name_));
    counts_ = std::make_unique<Counts>(Counts{sender, receiver});
}

void LinkDirection::tell_watchers() const {
    for (const LinkEngineMemory* memory : memories_)
        if (memory && memory->watcher)
            memory->watcher->link_will_change();
}

void LinkDirection::give(std::uint32_t bytes) {
    if (bytes == 0 || std::exchange(counts_->gives, true))
        throw std::logic_error(
            fmt::format("{}: give() needs at least one byte, and a call of sent() for the preceding bytes", name_));
    tell_watchers();
    LinkCourse::Touch touch(course_);
    counts_->to_give = counts_->given = bytes;
    begin_part_by_counts(*touch);
    touch.begin_if_free(number_);
}

void LinkDirection::take(std::uint32_t bytes) {
    if (bytes == 0 || std::exchange(counts_->takes, true))
        throw std::logic_error(
            fmt::format("{}: take() needs at least one byte, and a call of taken() for the preceding bytes", name_));
    tell_watchers();
    counts_->to_take = bytes;
    ask_by_counts();
}

/// Begins a part with all bytes that are offered. If the receiver has asked for fewer bytes, shortens the part.
void LinkDirection::begin_part_by_counts(LinkState& state) {
    begin_part_of(state, counts_->to_give);
    counts_->to_give = counts_->agreed = 0;
    state.ask_for_byte(number_, std::max(state.may_start(number_), kernel_.now()));
    if (state.is_sure_of_receiver(number_))
        agree_on_part(state);
}

/// Shortens the part to the receiver's count. This is possible until the second byte begins to travel. Returns whether
/// there is a part that the receiver can take.
bool LinkDirection::agree_on_part(LinkState& state) {
    LinkState::Direction& direction = state.directions[number_];
    LinkPackets::Stream& stream = state.packets.streams[number_];
    const bool has_begun = direction.phase == Phase::unnoticed || direction.phase == Phase::owed;
    const bool is_to_begin = direction.phase == Phase::travels && !stream.acknowledge;
    if (!has_begun && !is_to_begin)
        return false;
    const std::uint32_t bytes = std::min(direction.part_bytes, counts_->to_take);
    counts_->to_give += direction.part_bytes - bytes;
    counts_->to_take -= bytes;
    counts_->agreed = bytes;
    const bool is_last_now = has_begun && bytes == 1 && stream.bytes_left > 0;
    direction.part_bytes = bytes;
    stream.bytes_left = bytes - std::uint32_t{has_begun};
    if (is_last_now && direction.first_byte == LinkState::FirstByte::asked_for)
        state.expect_last_byte(number_, times_);
    if (is_last_now)
        trace_standstill();
    return true;
}

/// Asks the sender for the bytes that the receiver still wants.
void LinkDirection::ask_by_counts() {
    bool all_here = false;
    {
        LinkCourse::Touch touch(course_);
        if (agree_on_part(*touch))
            all_here = receiver_asks(touch);
        else
            touch->directions[number_].receiver = LinkState::Receiver::waits;
    }
    if (all_here)
        end_of_taking();
}

/// Ends the receiver's transfer after a part has arrived, or asks for the bytes that are still missing.
void LinkDirection::end_of_taking() {
    if (counts_->to_take > 0)
        return ask_by_counts();
    counts_->takes = false;
    counts_->receiver.taken();
}

bool LinkDirection::is_taken() {
    LinkCourse::Touch touch(course_); // performs the steps that are due
    const LinkState::Direction& direction = touch->directions[number_];
    return counts_->takes && counts_->to_take == 0 && direction.ends == LinkState::Ends::agree &&
           (direction.part_bytes == 0 || bytes_received() == direction.part_bytes);
}

std::uint32_t LinkDirection::reset_giving() {
    tell_watchers();
    LinkCourse::Touch touch(course_);
    const auto received = static_cast<std::uint32_t>(counts_->gives ? bytes_received() : 0);
    if (counts_->gives) {
        sent_when_given_up_ =
            counts_->given - counts_->to_give - touch->directions[number_].part_bytes + bytes_acknowledged();
        drop_output(touch);
        end_part(*touch);
        if (received == 0)
            counts_->to_take += counts_->agreed;
    }
    counts_->gives = false;
    counts_->to_give = counts_->agreed = 0;
    if (LinkState::Direction& direction = touch->directions[number_]; direction.ends == LinkState::Ends::receiver_left)
        direction.ends = LinkState::Ends::agree;
    return received;
}

std::uint32_t LinkDirection::reset_taking() {
    tell_watchers();
    LinkCourse::Touch touch(course_);
    LinkState::Direction& direction = touch->directions[number_];
    if (counts_->takes)
        forget_asked_byte(touch);
    const auto received = static_cast<std::uint32_t>(bytes_received());
    receiver_leaves(touch);
    counts_->takes = false;
    counts_->to_take = 0;
    if (direction.ends == LinkState::Ends::sender_left)
        direction.ends = LinkState::Ends::agree;
    return received;
}

void LinkDirection::step_performed_by_counts(LinkState& state, LinkStep step, const LinkState::Outcome& outcome) {
    switch (step) {
    case LinkStep::byte_begins:
        if (channel_)
            trace_byte(state, outcome);
        return;
    case LinkStep::acknowledge_begins:
        if (outcome.is_lost)
            trace_standstill();
        return;
    case LinkStep::byte_is_noticed:
        if (state.packets.streams[number_].bytes_left > 0)
            trace_standstill();
        return;
    case LinkStep::first_byte_arrives:
        if (state.directions[number_].first_byte == LinkState::FirstByte::waits)
            counts_->receiver.byte_waits();
        return;
    case LinkStep::last_byte_arrives:
        if (outcome.wakes)
            end_of_taking();
        return;
    case LinkStep::sending_ends:
        end_part(state);
        if (counts_->to_give > 0)
            return begin_part_by_counts(state);
        counts_->gives = false;
        return counts_->sender.sent();
    default: return;
    }
}

} // namespace placedpar::hardware
