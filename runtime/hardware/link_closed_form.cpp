// The closed form of a link.

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>

namespace placedpar::hardware {

ClosedForm::ClosedForm(Kernel& kernel, const PacketTimes& times, LinkDirection& a_to_b, LinkDirection& b_to_a)
    : kernel_(kernel), a_to_b_(a_to_b), b_to_a_(b_to_a), times_(times) {}

void ClosedForm::look_ahead() {
    if (a_to_b_.must_be_seen() || b_to_a_.must_be_seen())
        return;
    LinkStreams ahead{kernel_.now(),
                      {a_to_b_.stream(), b_to_a_.stream()},
                      {a_to_b_.out_.free_at(), b_to_a_.out_.free_at()},
                      kernel_.trace() != nullptr};
    Time certain = end_of_what_is_certain();
    if (!ahead.may_advance(certain))
        return;
    behind_ = ahead;
    repetition_.find(ahead, times_, certain);
    ahead_until_ = ahead.now;
    if (is_ahead())
        go_to(ahead, ahead_until_);
}

/// Lets the packets that are behind begin, up to that moment.
void ClosedForm::follow(Time before) {
    if (repetition_.since <= kernel_.now()) {
        if (behind_.now < repetition_.since)
            behind_ = repetition_.first;
        repetition_.pass_periods(behind_, before);
    }
    behind_.advance(times_, before);
}

/// Events that come after this may change what the link does.
Time ClosedForm::end_of_what_is_certain() const {
    constexpr Time end_of_time = Time::max() - std::chrono::hours{1}; // later moments are rounded to it
    Time end = a_to_b_.faults_ ? std::min(end_of_time, a_to_b_.faults_->steady_until(kernel_.now())) : end_of_time;
    for (const LinkDirection* direction : {&a_to_b_, &b_to_a_})
        if (direction->next_ == LinkDirection::Packet::acknowledge && !direction->waits_for_receiver() &&
            !direction->is_sure_of_its_receiver())
            end = std::min(end, direction->next_due_);
    return end;
}

/// Packets of this very moment have begun, or been asked for. That is right because of the order within an instant
/// (EventQueue::Priority): this has happened before a process or a timer does anything.
void ClosedForm::come_back() {
    Time after = kernel_.now() + Time{1};
    follow(after);
    ahead_until_ = kernel_.now();
    repetition_.forget();
    go_to(behind_, after);
}

LinkStreams::Progress ClosedForm::passed_until_now(std::size_t direction) {
    follow(kernel_.now() + Time{1});
    return {behind_.streams[direction].bytes_left, behind_.streams[direction].last_start};
}

/// Packets that are due at that moment or later are still to be asked for, by steps.
void ClosedForm::go_to(const LinkStreams& streams, Time moment) {
    const LinkStreams::Stream &forth = streams.streams[0], &back = streams.streams[1];
    auto waits = [moment](const LinkStreams::Stream& s, bool acknowledge) {
        return s.acknowledge == acknowledge && s.due < moment;
    };
    a_to_b_.out_.go_to(streams.free_at[0], waits(forth, false) ? &a_to_b_ : nullptr,
                       waits(back, true) ? &b_to_a_ : nullptr);
    b_to_a_.out_.go_to(streams.free_at[1], waits(back, false) ? &b_to_a_ : nullptr,
                       waits(forth, true) ? &a_to_b_ : nullptr);
    a_to_b_.go_to(forth, moment);
    b_to_a_.go_to(back, moment);
}

/// What the packets of this direction that follow need of it.
LinkStreams::Stream LinkDirection::stream() const {
    LinkStreams::Stream stream{.bytes_left = part_.bytes_left, .last_start = part_.last_start};
    stream.acknowledge = (next_ == Packet::acknowledge && !waits_for_receiver()) || back_.acknowledge_waits(*this);
    if (stream.acknowledge || next_ == Packet::byte || out_.byte_waits(*this))
        stream.due = next_due_;
    return stream;
}

/// Whether steps must stand for its next packets, if any are to come. A trace is told of the first byte after a break,
/// which may be that behind an acknowledge that still waits for its wire.
bool LinkDirection::must_be_seen() const {
    bool begins = next_ == Packet::byte || out_.byte_waits(*this);
    bool first_byte_begins = begins && part_.bytes_left == part_bytes();
    bool to_be_traced = kernel_.trace() && !trace_carries_ && part_.bytes_left > 0 && stream().flows();
    return every_byte_ || first_byte_begins || to_be_traced || left_over_ || receiver_left_;
}

/// It is certain that the receiver will take the byte under way. One that still waits for the end of the part before
/// may not.
bool LinkDirection::receiver_takes_byte() const {
    bool is_last = part_.bytes_left == 0;
    return receiver_ && (!has(arrivals_of_last[0]) || (is_last && !last_of_part_)) &&
           (!has(arrivals_of_last[1]) || (is_last && last_of_part_));
}

/// The byte under way, a first one, waits for a process that asks for it: until then nothing follows, and whoever comes
/// sees for himself whether it has been noticed yet. A trace is told when it is. Without overlap it arrives before it
/// is noticed, which is the last that happens in a run that gets stuck.
bool LinkDirection::waits_for_receiver() const {
    return next_ == Packet::acknowledge && !receiver_ && !taken_ && !every_byte_ && !kernel_.trace() &&
           times_.overlaps();
}

/// The byte under way, which comes over.
bool LinkDirection::is_unnoticed() const { return unacknowledged_ && kernel_.now() < next_due_; }

void LinkDirection::go_to(const LinkStreams::Stream& stream, Time moment) {
    if (!stream.flows())
        return;
    if (stream.bytes_left > 0 && part_.bytes_left == 0)
        drop(arrival_of_last());
    else if (stream.bytes_left == 0 && part_.bytes_left > 0)
        foresee_arrival_of_last(stream.last_start);
    bytes_carried_ += part_.bytes_left;
    bytes_carried_ -= part_.bytes_left = stream.bytes_left;
    part_.last_start = stream.last_start;
    unacknowledged_ = stream.acknowledge;
    byte_comes_over_ = true;
    may_start_ = stream.acknowledge ? part_.last_start : std::max(part_.last_start, stream.due);
    bool is_asked_for = stream.due < moment;
    await(is_asked_for ? Packet::none : stream.acknowledge ? Packet::acknowledge : Packet::byte, stream.due);
}

} // namespace placedpar::hardware
