#include "runtime/hardware/link_period.hpp"

namespace placedpar::hardware {

namespace {

constexpr std::size_t none = 2;

/// The direction whose packet begins next; none if no packet may within the limit. If both directions want one wire,
/// the acknowledge goes first. On two wires the order of one instant makes no difference.
std::size_t next_within(const LinkPackets& packets, const LinkLimit& limit) {
    Time begins[] = {packets.begin_of_next(0), packets.begin_of_next(1)};
    bool first = begins[0] < begins[1] || (begins[0] == begins[1] && packets.streams[0].acknowledge);
    std::size_t direction = first ? 0 : 1;
    const LinkPackets::Stream& stream = packets.streams[direction];
    bool stops = stream.ends_part() && (stream.acknowledge || limit.last_bytes_stop);
    return begins[direction] >= limit.before || stops ? none : direction;
}

/// Lets that packet begin, and returns its direction.
std::size_t begin_next(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) {
    std::size_t direction = next_within(packets, limit);
    if (direction != none) {
        packets.now = packets.begin_of_next(direction);
        packets.begin(times, direction);
    }
    return direction;
}

/// When the first of the last bytes of parts began, of those that have; else never.
Time end_of_a_part(const LinkPackets& packets) {
    Time end = never;
    for (const LinkPackets::Stream& stream : packets.streams)
        if (stream.flows() && stream.bytes_left == 0)
            end = std::min(end, stream.last_start);
    return end;
}

/// Whether everything will come again as it came then, seen from each moment. REQUIRES: the direction that is not
/// `other` began a byte at both.
bool is_in_phase(const LinkPackets& now, const LinkPackets& then, std::size_t other) {
    auto ahead = [](Time moment, Time of) { return std::max(moment - of, Time{0}); };
    const LinkPackets::Stream &stream = now.streams[other], &before = then.streams[other];
    return stream.acknowledge == before.acknowledge &&
           (!stream.flows() || ahead(stream.due, now.now) == ahead(before.due, then.now)) &&
           ahead(now.free_at[other], now.now) == ahead(then.free_at[other], then.now);
}

/// Asked of the stream whose packet has begun last.
bool has_begun_last_byte(const LinkPackets::Stream& stream) { return stream.acknowledge && stream.bytes_left == 0; }

/// All packets within the limit, up to the last byte of a part.
void run_each(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) {
    for (std::size_t next; (next = begin_next(packets, times, limit)) != none;)
        if (has_begun_last_byte(packets.streams[next]))
            return;
}

} // namespace

void LinkPeriod::run(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) const {
    if (since < limit.before) {
        if (packets.now < since)
            packets = first;
        pass_periods(packets, limit.before);
    }
    run_each(packets, times, limit);
}

/// The present is compared with one moment that was noted: a later one each time that twice as many bytes began.
bool LinkPeriod::find(LinkPackets& packets, const PacketTimes& times, const LinkLimit& limit) {
    since = never;
    LinkPackets noted;
    std::uint32_t bytes_until_note = 1, bytes_between_notes = 1;
    bool any = false;
    for (std::size_t next; (next = begin_next(packets, times, limit)) != none;) {
        any = true;
        const bool marks = packets.streams[next].acknowledge && (next == 0 || !packets.streams[0].flows());
        if (marks && bytes_between_notes > 1 && is_in_phase(packets, noted, 1 - next)) {
            begin(noted, packets);
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

/// Everything is as it was then, so that it has repeated itself since: short periods are known from there on.
void LinkPeriod::begin(const LinkPackets& then, const LinkPackets& now) {
    length = now.now - then.now;
    first = length <= longest_simple ? then : now;
    since = first.now;
    for (std::size_t i : {0u, 1u}) {
        const LinkPackets::Stream& stream = now.streams[i];
        std::uint32_t bytes = then.streams[i].bytes_left - stream.bytes_left;
        auto counted = [from = bytes > 0 ? now.now : since](Time start) {
            return static_cast<std::int32_t>(std::max(start - from, -longest_simple).count());
        };
        paces[i] = {then.streams[i].bytes_left, bytes, counted(stream.last_start), counted(stream.start_before)};
    }
}

void LinkPeriod::pass_periods(LinkPackets& packets, Time before) const {
    // None where the last byte of a part has begun: of its bytes none is left, so that the bound is negative.
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
            // One that began before the first period may have done so at another distance.
            bool extrapolated = stream.last_start < since && length <= longest_simple;
            stream.last_start = by + (extrapolated ? since + Time{paces[i].last_start} : stream.last_start);
            stream.start_before += by;
        }
    }
}

} // namespace placedpar::hardware
