// Bytes that are moved by counts at both ends, which need not agree.
//
// What the ends agree on is a part: as many bytes as both have said. When it ends for one of them it has done what it
// was asked for, or a new part begins with what the other has said meanwhile.

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar::hardware {

using Phase = LinkState::Phase;

void LinkDirection::move_by_counts(ByteUser& sender, ByteUser& receiver) {
    if (channel_ || writer_ || reader_)
        throw std::logic_error(
            fmt::format("{} carries messages already, so that its bytes cannot be moved by counts", name_));
    counts_ = std::make_unique<Counts>(Counts{sender, receiver});
}

void LinkDirection::give(std::uint32_t bytes) {
    LinkCourse::Touch touch(course_);
    counts_->to_give = bytes;
    begin_part_by_counts(*touch);
    touch.begin_if_free(number_);
}

void LinkDirection::take(std::uint32_t bytes) {
    counts_->to_take = bytes;
    ask_by_counts();
}

/// With all that is to be given, if nobody asks yet.
void LinkDirection::begin_part_by_counts(LinkState& state) {
    begin_part_of(state, counts_->to_give);
    counts_->to_give = 0;
    state.ask_for_byte(number_, std::max(state.may_start(number_), kernel_.now()));
    if (state.is_sure_of_receiver(number_))
        agree_on_part(state);
}

/// The receiver asks while not more than the first byte of a part has begun: so the part may still be made shorter, as
/// its count says. Returns whether a part is there to be taken.
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
    const bool is_last_now = has_begun && bytes == 1 && stream.bytes_left > 0;
    direction.part_bytes = bytes;
    stream.bytes_left = bytes - std::uint32_t{has_begun};
    if (is_last_now && direction.first_byte == LinkState::FirstByte::asked_for)
        state.expect_last_byte(number_, times_);
    return true;
}

/// For as many bytes as are to be taken.
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

/// The part has arrived.
void LinkDirection::end_of_taking() {
    if (counts_->to_take > 0)
        ask_by_counts();
    else
        counts_->receiver.taken();
}

void LinkDirection::taken_by_counts(LinkState& state, LinkStep step, const LinkState::Outcome& outcome) {
    switch (step) {
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
        if (counts_->to_give == 0)
            return counts_->sender.sent();
        return begin_part_by_counts(state);
    default: return;
    }
}

} // namespace placedpar::hardware
