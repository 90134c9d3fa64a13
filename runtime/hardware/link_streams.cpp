#include "runtime/hardware/link_streams.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

Time LinkStreams::State::begin_of_next(std::size_t direction) const {
    const Stream& stream = streams[direction];
    return stream.flows ? std::max(stream.due, free_at[wire_of(direction)]) : Time::max();
}

void LinkStreams::State::begin_packet(const PacketTimes& times, std::size_t direction) {
    Stream& stream = streams[direction];
    free_at[wire_of(direction)] = now + (stream.acknowledge ? times.acknowledge : times.data);
    stream.due = now + (stream.acknowledge ? times.to_next_byte : times.to_acknowledge);
    if (!stream.acknowledge) {
        --stream.bytes_left;
        stream.start_before = std::exchange(stream.last_start, now);
    }
    stream.acknowledge = !stream.acknowledge;
}

/// Whether the other direction is where it was then, seen from each moment, and so everything will come again.
/// REQUIRES: a direction began a byte at both.
bool LinkStreams::State::is_in_phase_with(const State& then, std::size_t other) const {
    auto ahead = [](Time moment, Time of) { return std::max(moment - of, Time{0}); };
    const Stream &stream = streams[other], &before = then.streams[other];
    return stream.acknowledge == before.acknowledge &&
           (!stream.flows || ahead(stream.due, now) == ahead(before.due, then.now)) &&
           ahead(free_at[other], now) == ahead(then.free_at[other], then.now);
}

/// If both directions want one wire, the acknowledge goes first. On two wires the order of one instant makes no
/// difference.
void LinkStreams::advance(const PacketTimes& times, Time before) {
    auto is_seen = [](const Stream& stream) { return stream.bytes_left == (stream.acknowledge ? 0 : 1); };
    pass_periods(before);
    for (;;) {
        Time begins[] = {at_.begin_of_next(0), at_.begin_of_next(1)};
        bool first = begins[0] < begins[1] || (begins[0] == begins[1] && at_.streams[0].acknowledge);
        std::size_t next = first ? 0 : 1;
        if (begins[next] >= before || is_seen(at_.streams[next]))
            return;
        at_.now = begins[next];
        at_.begin_packet(times, next);
        bool marks = at_.streams[next].acknowledge && (first || !at_.streams[0].flows);
        if (marks && watch_for_repetition(1 - next))
            pass_periods(before);
    }
}

/// Whether the period has just been found. REQUIRES: the direction that is not `other` has begun a byte now.
bool LinkStreams::watch_for_repetition(std::size_t other) {
    if (period_ > Time{0})
        return false;
    bool has_noted = bytes_between_notes_ > 1;
    if (has_noted && at_.is_in_phase_with(noted_, other)) {
        period_ = at_.now - noted_.now;
        for (std::size_t i : {0u, 1u})
            bytes_a_period_[i] = noted_.streams[i].bytes_left - at_.streams[i].bytes_left;
        noted_ = at_;
        return true;
    }
    if (--bytes_until_note_ == 0) {
        bytes_until_note_ = bytes_between_notes_ *= 2;
        noted_ = at_;
    }
    return false;
}

/// If the period is known, passes as many whole periods as end before that moment and before the last byte of a part.
void LinkStreams::pass_periods(Time before) {
    if (period_ == Time{0})
        return;
    std::int64_t periods = (before - at_.now - Time{1}) / period_;
    for (std::size_t i : {0u, 1u})
        if (bytes_a_period_[i] > 0)
            periods = std::min<std::int64_t>(periods, (at_.streams[i].bytes_left - 1) / bytes_a_period_[i]);
    if (periods <= 0)
        return;
    Time by = periods * period_;
    at_.now += by;
    for (std::size_t i : {0u, 1u}) {
        Stream& stream = at_.streams[i];
        at_.free_at[i] += by;
        stream.due += by;
        if (bytes_a_period_[i] > 0) {
            stream.bytes_left -= static_cast<std::uint32_t>(periods) * bytes_a_period_[i];
            stream.last_start += by;
            stream.start_before += by;
        }
    }
}

LinkStreams::Progress LinkStreams::progress(const PacketTimes& times, std::size_t direction, Time moment) {
    const Stream& stream = at_.streams[direction];
    std::uint32_t bytes_a_period = bytes_a_period_[direction];
    if (bytes_a_period != 1 && bytes_a_period != 2) { // these two are nearly all
        advance(times, moment + Time{1});
        return stream;
    }
    std::int64_t periods = (moment - stream.last_start) / period_;
    Progress then{stream.bytes_left - static_cast<std::uint32_t>(periods) * bytes_a_period,
                  stream.last_start + periods * period_};
    Time next = stream.start_before + (periods + 1) * period_;
    return bytes_a_period == 2 && next <= moment ? Progress{then.bytes_left - 1, next} : then;
}

} // namespace placedpar::hardware
