#include "runtime/hardware/link_streams.hpp"

#include <algorithm>

namespace placedpar::hardware {

Time LinkStreams::begin_of_next(std::size_t direction) const {
    const Stream& stream = streams_[direction];
    return stream.flows ? std::max(stream.due, free_at_[wire_of(direction)]) : Time::max();
}

/// If both want one wire, the acknowledge goes first. On two wires the order of one instant makes no difference.
std::size_t LinkStreams::next_direction() const {
    Time first = begin_of_next(0), second = begin_of_next(1);
    return first < second || (first == second && streams_[0].acknowledge) ? 0 : 1;
}

bool LinkStreams::is_seen(const Stream& stream) const { return stream.bytes_left == (stream.acknowledge ? 0 : 1); }

void LinkStreams::advance(const PacketTimes& times, Time before) {
    for (;;) {
        std::size_t next = next_direction();
        Time begin = begin_of_next(next);
        if (begin >= before || is_seen(streams_[next]))
            return;
        now_ = begin;
        begin_packet(times, next);
        bool first_of_those_that_flow = next == 0 || !streams_[0].flows;
        if (first_of_those_that_flow && streams_[next].acknowledge)
            watch_for_period(1 - next, before);
    }
}

void LinkStreams::begin_packet(const PacketTimes& times, std::size_t direction) {
    Stream& stream = streams_[direction];
    Time& free_at = free_at_[wire_of(direction)];
    if (stream.acknowledge) {
        free_at = now_ + times.acknowledge;
        stream.due = now_ + times.to_next_byte;
    } else {
        free_at = now_ + times.data;
        stream.due = now_ + times.to_acknowledge;
        stream.last_start = now_;
        --stream.bytes_left;
    }
    stream.acknowledge = !stream.acknowledge;
}

LinkStreams::Phase LinkStreams::phase_of(std::size_t other) const {
    const Stream& stream = streams_[other];
    Time due = stream.flows ? std::max(stream.due, now_) - now_ : Time{0};
    return {stream.acknowledge, due, std::max(free_at_[other], now_) - now_};
}

/// REQUIRES: the direction that is not `other` has begun a byte now.
void LinkStreams::watch_for_period(std::size_t other, Time before) {
    Phase here = phase_of(other);
    bool repeats = bytes_between_notes_ > 1 && here == noted_;
    if (repeats)
        pass_periods(before);
    if (repeats || --bytes_until_note_ == 0) {
        noted_ = here;
        noted_at_ = now_;
        bytes_left_then_ = {streams_[0].bytes_left, streams_[1].bytes_left};
        bytes_until_note_ = bytes_between_notes_ *= 2;
    }
}

/// Until before the moment, and before the last byte of a part.
void LinkStreams::pass_periods(Time before) {
    Time period = now_ - noted_at_;
    std::int64_t periods = (before - now_ - Time{1}) / period;
    std::array<std::uint32_t, 2> bytes{};
    for (std::size_t i : {0u, 1u})
        if ((bytes[i] = bytes_left_then_[i] - streams_[i].bytes_left) > 0)
            periods = std::min<std::int64_t>(periods, (streams_[i].bytes_left - 1) / bytes[i]);
    Time by = periods * period;
    now_ += by;
    for (std::size_t i : {0u, 1u}) {
        free_at_[i] += by;
        Stream& stream = streams_[i];
        stream.bytes_left -= static_cast<std::uint32_t>(periods) * bytes[i];
        if (stream.flows)
            stream.due += by, stream.last_start += by;
    }
}

} // namespace placedpar::hardware
