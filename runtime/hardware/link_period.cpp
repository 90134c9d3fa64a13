#include "runtime/hardware/link_period.hpp"

#include <utility>

namespace placedpar::hardware {

namespace {

constexpr std::size_t none = 2;

/// Begins the next packet (a byte or an acknowledge) and returns its direction, or returns `none` if the limit excludes
/// the packet. If a byte and an acknowledge can begin at the same time, the acknowledge goes first, because both need
/// the same wire (`orders` in link_state.cpp). Two bytes or two acknowledges are on different wires, so their order
/// does not matter.
std::size_t begin_next(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) {
    const Time forth = packets.begin_of_next(0), back = packets.begin_of_next(1);
    const bool first = forth < back || (forth == back && packets.streams[0].acknowledge);
    const std::size_t direction = first ? 0 : 1;
    const Time begin = first ? forth : back;
    const LinkPackets::Stream& stream = packets.streams[direction];
    const bool stops = stream.ends_part() && (stream.acknowledge || limit.last_bytes_stop);
    if (begin >= limit.before || stops)
        return none;
    packets.now = begin;
    packets.begin(times, direction);
    return direction;
}

/// Returns when the last byte of a message part began. If both directions have begun such a byte, returns the earlier
/// time; if none has, returns `never`.
Time end_of_a_part(const LinkPackets& packets) {
    Time end = never;
    for (const LinkPackets::Stream& stream : packets.streams)
        if (stream.flows() && stream.bytes_left == 0)
            end = std::min(end, stream.last_start);
    return end;
}

/// Returns whether the packets after `now` repeat the packets after `then`. REQUIRES: the direction opposite to `other`
/// began a byte at both times.
bool is_in_phase(const LinkPackets& now, const LinkPackets& then, std::size_t other) {
    auto ahead = [](Time moment, Time of) { return std::max(moment - of, Time{0}); };
    const LinkPackets::Stream &stream = now.streams[other], &before = then.streams[other];
    return stream.acknowledge == before.acknowledge &&
           (!stream.flows() || ahead(stream.due, now.now) == ahead(before.due, then.now)) &&
           ahead(now.free_at[other], now.now) == ahead(then.free_at[other], then.now);
}

/// Returns whether the last packet of this direction was the last byte of a part.
bool has_begun_last_byte(const LinkPackets::Stream& stream) { return stream.acknowledge && stream.bytes_left == 0; }

/// Begins all packets within the limit, up to the last byte of a part.
void run_each(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) {
    for (std::size_t next; (next = begin_next(packets, times, limit)) != none;)
        if (has_begun_last_byte(packets.streams[next]))
            return;
}

} // namespace

void LinkPeriod::replay(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) const {
    if (since < limit.before) {
        if (packets.now < since)
            packets = {since, streams, free_at};
        pass_periods(packets, limit.before);
    }
    run_each(packets, times, limit);
}

/// Compares the state after each byte with a copy of an earlier state: if they are alike, a period has passed. A new
/// copy is made after 1, 2, 4, 8 ... bytes, so a period of any length is found.
bool LinkPeriod::find(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) {
    since = never;
    LinkPackets noted;
    std::array<Time, 2> starts{}, starts_before{}; // when the last byte began, and the byte before it
    std::uint32_t bytes_until_note = 1, bytes_between_notes = 1;
    bool any = false;
    for (std::size_t next; (next = begin_next(packets, times, limit)) != none;) {
        any = true;
        const bool is_byte = packets.streams[next].acknowledge;
        if (is_byte)
            starts_before[next] = std::exchange(starts[next], packets.now);
        const bool marks = is_byte && (next == 0 || !packets.streams[0].flows());
        if (marks && bytes_between_notes > 1 && is_in_phase(packets, noted, 1 - next)) {
            begin(noted, packets, starts_before);
            pass_periods(packets, limit.before);
            if (!has_begun_last_byte(packets.streams[next]))
                run_each(packets, times, limit);
            break;
        }
        if (has_begun_last_byte(packets.streams[next]))
            break;
        if (marks && --bytes_until_note == 0) {
            bytes_until_note = bytes_between_notes *= 2;
            noted = packets;
        }
    }
    until = needs_no_passing() ? std::min(end_of_a_part(packets), packets.now) : Time{-1};
    return any;
}

/// Stores the period between `then` and `now`. A short period is known from `then` on, a long period only from `now`
/// on. `starts_before`: when each direction began its last byte but one.
void LinkPeriod::begin(const LinkPackets& then, const LinkPackets& now, const std::array<Time, 2>& starts_before) {
    length = now.now - then.now;
    const LinkPackets& first = length <= longest_simple ? then : now;
    since = first.now;
    streams = first.streams;
    free_at = first.free_at;
    for (std::size_t i : {0u, 1u}) {
        const LinkPackets::Stream& stream = now.streams[i];
        std::uint32_t bytes = then.streams[i].bytes_left - stream.bytes_left;
        auto counted = [from = bytes > 0 ? now.now : since](Time start) {
            return static_cast<std::int32_t>(std::max(start - from, -longest_simple).count());
        };
        paces[i] = {then.streams[i].bytes_left, bytes, counted(stream.last_start), counted(starts_before[i])};
    }
}

void LinkPeriod::pass_periods(LinkPackets& packets, Time before) const {
    // If the last byte of a part has begun, no byte of the part is left. `periods` then becomes negative, and no period
    // is skipped.
    std::int64_t periods = (before - packets.now - Time{1}) / length;
    for (std::size_t i : {0u, 1u})
        if (std::uint32_t bytes = paces[i].bytes_a_period)
            periods = std::min<std::int64_t>(periods, (std::int64_t{packets.streams[i].bytes_left} - 1) / bytes);
    if (periods <= 0)
        return;
    Time by = periods * length;
    packets.now += by;
    for (std::size_t i : {0u, 1u}) {
        LinkPackets::Stream& stream = packets.streams[i];
        packets.free_at[i] += by;
        if (stream.flows())
            stream.due += by;
        if (std::uint32_t bytes = paces[i].bytes_a_period) {
            stream.bytes_left -= static_cast<std::uint32_t>(periods) * bytes;
            // A byte that began before the first period need not fit into the pattern.
            bool extrapolated = stream.last_start < since && length <= longest_simple;
            stream.last_start = by + (extrapolated ? since + Time{paces[i].last_start} : stream.last_start);
        }
    }
}

} // namespace placedpar::hardware
