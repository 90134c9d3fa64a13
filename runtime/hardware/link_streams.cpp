#include "runtime/hardware/link_streams.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

Time LinkStreams::begin_of_next(std::size_t direction) const {
    return std::max(streams[direction].due, free_at[wire_of(direction)]);
}

/// Without a branch, since the processor cannot foresee whether it is a byte.
void LinkStreams::begin_packet(const PacketTimes& times, std::size_t direction) {
    Stream& stream = streams[direction];
    const bool acknowledge = stream.acknowledge;
    const PacketTimes::Packet& packet = times.packets[acknowledge];
    const Time last_start = stream.last_start, start_before = stream.start_before;
    free_at[wire_of(direction)] = now + packet.carried;
    stream.due = now + packet.to_answer;
    stream.bytes_left -= std::uint32_t{!acknowledge};
    stream.last_start = acknowledge ? last_start : now;
    stream.start_before = acknowledge ? start_before : last_start;
    stream.acknowledge = !acknowledge;
}

/// If both directions want one wire, the acknowledge goes first. On two wires the order of one instant makes no
/// difference.
std::optional<LinkStreams::Next> LinkStreams::next(Time before) const {
    auto is_seen = [this](const Stream& stream) {
        return stream.acknowledge ? stream.bytes_left == 0 : stream.bytes_left == 1 && last_bytes_are_seen;
    };
    Time begins[] = {begin_of_next(0), begin_of_next(1)};
    bool first = begins[0] < begins[1] || (begins[0] == begins[1] && streams[0].acknowledge);
    std::size_t direction = first ? 0 : 1;
    if (begins[direction] >= before || is_seen(streams[direction]))
        return std::nullopt;
    return Next{direction, begins[direction]};
}

std::optional<std::size_t> LinkStreams::begin_next(const PacketTimes& times, Time before) {
    std::optional<Next> packet = next(before);
    if (!packet)
        return std::nullopt;
    now = packet->begins;
    begin_packet(times, packet->direction);
    return packet->direction;
}

Time LinkStreams::end_of_a_part() const {
    Time end = Time::max();
    for (const Stream& stream : streams)
        if (stream.flows() && stream.bytes_left == 0)
            end = std::min(end, stream.last_start);
    return end;
}

bool LinkStreams::is_in_phase_with(const LinkStreams& then, std::size_t other) const {
    auto ahead = [](Time moment, Time of) { return std::max(moment - of, Time{0}); };
    const Stream &stream = streams[other], &before = then.streams[other];
    return stream.acknowledge == before.acknowledge &&
           (!stream.flows() || ahead(stream.due, now) == ahead(before.due, then.now)) &&
           ahead(free_at[other], now) == ahead(then.free_at[other], then.now);
}

/// The present is compared with one moment that was noted: a later one each time that twice as many bytes began.
void Repetition::find(LinkStreams& streams, const PacketTimes& times, Time before) {
    since = Time::max();
    LinkStreams noted;
    std::uint32_t bytes_until_note = 1, bytes_between_notes = 1;
    while (std::optional<std::size_t> next = streams.begin_next(times, before)) {
        bool marks = streams.streams[*next].acknowledge && (*next == 0 || !streams.streams[0].flows());
        if (!marks)
            continue;
        if (bytes_between_notes > 1 && streams.is_in_phase_with(noted, 1 - *next)) {
            begin(noted, streams);
            pass_periods(streams, before);
            streams.advance(times, before);
            break;
        }
        if (--bytes_until_note == 0) {
            bytes_until_note = bytes_between_notes *= 2;
            noted = streams;
        }
    }
    until = needs_no_passing() ? std::min(streams.end_of_a_part(), streams.now) : LinkStreams::past;
}

/// Everything is as it was then, so that it has repeated itself since: short periods are known from there on.
void Repetition::begin(const LinkStreams& then, const LinkStreams& now) {
    period = now.now - then.now;
    first = period <= longest_simple ? then : now;
    since = first.now;
    for (std::size_t i : {0u, 1u}) {
        const LinkStreams::Stream& stream = now.streams[i];
        std::uint32_t bytes = then.streams[i].bytes_left - stream.bytes_left;
        auto counted = [from = bytes > 0 ? now.now : since](Time start) {
            return static_cast<std::int32_t>(std::max(start - from, -longest_simple).count());
        };
        flows[i] = {then.streams[i].bytes_left, bytes, counted(stream.last_start), counted(stream.start_before)};
    }
}

void Repetition::pass_periods(LinkStreams& streams, Time before) const {
    // None where the last byte of a part has begun: of its bytes none is left, so that the bound is negative.
    std::int64_t periods = (before - streams.now - Time{1}) / period;
    for (std::size_t i : {0u, 1u})
        if (std::uint32_t bytes = flows[i].bytes_a_period)
            periods = std::min<std::int64_t>(periods, (std::int64_t{streams.streams[i].bytes_left} - 1) / bytes);
    if (periods <= 0)
        return;
    Time by = periods * period;
    streams.now += by;
    for (std::size_t i : {0u, 1u}) {
        LinkStreams::Stream& stream = streams.streams[i];
        streams.free_at[i] += by;
        if (stream.flows())
            stream.due += by;
        if (std::uint32_t bytes = flows[i].bytes_a_period) {
            stream.bytes_left -= static_cast<std::uint32_t>(periods) * bytes;
            // One that began before the first period may have done so at another distance.
            bool extrapolated = stream.last_start < since && period <= longest_simple;
            stream.last_start = by + (extrapolated ? since + Time{flows[i].last_start} : stream.last_start);
            stream.start_before += by;
        }
    }
}

} // namespace placedpar::hardware
