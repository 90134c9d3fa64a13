#include "runtime/hardware/link_state.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

namespace {

constexpr std::uint8_t order_of(EventQueue::Priority priority, std::size_t rank) {
    return static_cast<std::uint8_t>(priority * LinkState::ranks + rank);
}

/// The order of a direction's steps among simultaneous steps: its requests for wires, and the end of a packet on its
/// own wire.
struct Orders {
    std::uint8_t acknowledge_asks, byte_asks, wire_is_free;
};
constexpr std::array<Orders, 2> orders{{
    {order_of(EventQueue::request, 1), order_of(EventQueue::start, 1), order_of(EventQueue::start, 0)},
    {order_of(EventQueue::request, 5), order_of(EventQueue::start, 5), order_of(EventQueue::start, 4)},
}};

/// The meaning of an entry of LinkState::arrivals.
struct Arrival {
    LinkStep step;
    std::uint8_t direction, order;
};
constexpr std::array<Arrival, LinkState::most_arrivals> kinds_of_arrivals{{
    {LinkStep::first_byte_arrives, 0, order_of(EventQueue::arrival, 1)},
    {LinkStep::last_byte_arrives, 0, order_of(EventQueue::arrival, 2)},
    {LinkStep::last_byte_arrives, 0, order_of(EventQueue::arrival, 2)},
    {LinkStep::sending_ends, 0, order_of(EventQueue::arrival, 3)},
    {LinkStep::first_byte_arrives, 1, order_of(EventQueue::arrival, 5)},
    {LinkStep::last_byte_arrives, 1, order_of(EventQueue::arrival, 6)},
    {LinkStep::last_byte_arrives, 1, order_of(EventQueue::arrival, 6)},
    {LinkStep::sending_ends, 1, order_of(EventQueue::arrival, 7)},
    {LinkStep::falls_silent, 0, order_of(EventQueue::arrival, 0)},
    {LinkStep::falls_silent, 1, order_of(EventQueue::arrival, 4)},
}};

/// Returns whether step a comes before step b. If two packets wait for the same wire, the acknowledge goes first.
/// next_within() in link_period.cpp follows the same rule.
bool comes_before(const LinkState::Next& a, const LinkState::Next& b) {
    if (a.at != b.at) [[likely]]
        return a.at < b.at;
    return a.order != b.order ? a.order < b.order : a.step == LinkStep::acknowledge_begins;
}

} // namespace

LinkState::Next LinkState::next_packet(std::size_t d) const {
    const LinkPackets::Stream& stream = packets.streams[d];
    const auto direction = static_cast<std::uint8_t>(d);
    if (!stream.flows()) {
        const Phase phase = directions[d].phase;
        if (phase == Phase::unnoticed)
            return {LinkStep::byte_is_noticed, direction, orders[d].acknowledge_asks, directions[d].at};
        if (phase == Phase::restarts)
            return {LinkStep::register_is_free, direction, orders[d].byte_asks, directions[d].at};
        return {.direction = direction};
    }
    const std::size_t wire = packets.wire_of(d);
    const bool waited = stream.due < packets.free_at[wire];
    const std::uint8_t asks = stream.acknowledge ? orders[d].acknowledge_asks : orders[d].byte_asks;
    return {stream.acknowledge ? LinkStep::acknowledge_begins : LinkStep::byte_begins, direction,
            waited ? orders[wire].wire_is_free : asks, packets.begin_of_next(d)};
}

LinkState::Next LinkState::next() const {
    Next forth = next_packet(0), back = next_packet(1);
    Next next = comes_before(back, forth) ? back : forth;
    const std::size_t arrival = first_arrival();
    if (arrivals[arrival] < next.at) {
        const Arrival& kind = kinds_of_arrivals[arrival];
        next = {kind.step, kind.direction, kind.order, arrivals[arrival]};
    }
    return next;
}

/// Has no branches in its loop, because the host processor cannot predict the outcome.
std::size_t LinkState::first_arrival() const {
    Time earliest = arrivals[0];
    std::size_t first = 0;
    for (std::size_t i = 1; i < arrivals.size(); ++i) {
        const bool is_earlier = arrivals[i] < earliest;
        first = is_earlier ? i : first;
        earliest = is_earlier ? arrivals[i] : earliest;
    }
    return first;
}

LinkState::Outcome LinkState::perform(const Next& next, const PacketTimes& times, Fate fate) {
    const std::size_t d = next.direction;
    Direction& direction = directions[d];
    packets.now = next.at;
    switch (next.step) {
    case LinkStep::byte_begins: return begin_byte(d, times, fate);
    case LinkStep::acknowledge_begins: return begin_acknowledge(d, times, fate);
    case LinkStep::byte_is_noticed: direction.phase = Phase::owed; break;
    case LinkStep::register_is_free: direction.phase = Phase::idle; break;
    case LinkStep::first_byte_arrives:
        drop_first_byte(d);
        if (direction.receiver == Receiver::absent)
            direction.first_byte = FirstByte::waits;
        break;
    case LinkStep::last_byte_arrives: return last_byte_arrives(d);
    case LinkStep::sending_ends: drop_end_of_sending(d); break;
    case LinkStep::falls_silent: arrivals[silence(d)] = never; break;
    }
    return {};
}

/// Begins a byte. A first byte whose receiver waits is noticed before the whole byte has arrived. If packets cannot be
/// lost, this arrival then changes nothing and is left out.
LinkState::Outcome LinkState::begin_byte(std::size_t d, const PacketTimes& times, Fate fate) {
    Direction& direction = directions[d];
    LinkPackets::Stream& stream = packets.streams[d];
    packets.begin(times, d);
    lasts_too_long = lasts_too_long || stream.due == never;
    if (fate == Fate::is_lost || direction.ends != Ends::agree) {
        direction.phase = Phase::byte_lost;
        stream.due = never;
        return {.is_lost = true};
    }
    const bool is_first = stream.bytes_left + 1 == direction.part_bytes;
    if (is_first && !is_first_byte_foreseen(d, times))
        expect_first_byte(d, times);
    if (direction.receiver_is == User::program || (is_first && !is_sure_of_receiver(d))) {
        direction.phase = Phase::unnoticed;
        direction.at = std::exchange(stream.due, never);
    }
    if (stream.bytes_left == 0)
        expect_last_byte(d, times);
    return {};
}

LinkState::Outcome LinkState::begin_acknowledge(std::size_t d, const PacketTimes& times, Fate fate) {
    Direction& direction = directions[d];
    LinkPackets::Stream& stream = packets.streams[d];
    const bool is_last = stream.bytes_left == 0;
    const bool delivers = is_last && direction.phase != Phase::delivered;
    packets.begin(times, d);
    lasts_too_long = lasts_too_long || stream.due == never;
    if (fate == Fate::is_lost) {
        direction.phase = Phase::acknowledge_lost;
        stream.due = never;
        return {.delivers = delivers, .is_lost = true};
    }
    if (is_last)
        expect(end_of_sending(d), later(packets.now, times.acknowledge_arrival()));
    if (is_last || direction.sender_is == User::program) {
        direction.phase = direction.sender_is == User::program ? Phase::restarts : Phase::idle;
        direction.at = std::exchange(stream.due, never);
    }
    return {.delivers = delivers};
}

/// Handles the arrival of a part's last byte. If the acknowledge of this byte has begun, the part was handed over then.
/// This is always so if the next part has begun.
LinkState::Outcome LinkState::last_byte_arrives(std::size_t d) {
    Direction& direction = directions[d];
    const LinkPackets::Stream& stream = packets.streams[d];
    arrivals[last(d)] = std::exchange(arrivals[last(d) + 1], never);
    if (direction.receiver == Receiver::absent)
        return {};
    direction.receiver = Receiver::absent;
    const bool waits_for_acknowledge =
        direction.phase == Phase::travels && stream.acknowledge && stream.bytes_left == 0;
    if (waits_for_acknowledge)
        direction.phase = Phase::delivered;
    return {.delivers = waits_for_acknowledge, .wakes = true};
}

void LinkState::note_last_bytes(const std::array<std::uint32_t, 2>& bytes_left_before, const PacketTimes& times) {
    for (std::size_t d : {0u, 1u})
        if (bytes_left_before[d] > 0 && packets.streams[d].bytes_left == 0)
            expect_last_byte(d, times);
}

void LinkState::ask_for_byte(std::size_t d, Time due) {
    LinkPackets::Stream& stream = packets.streams[d];
    directions[d].phase = Phase::travels;
    stream.acknowledge = false;
    stream.due = due;
}

void LinkState::ask_for_acknowledge(std::size_t d, Phase phase, Time due) {
    LinkPackets::Stream& stream = packets.streams[d];
    directions[d].phase = phase;
    stream.acknowledge = true;
    stream.due = due;
}

Time LinkState::may_start(std::size_t d) const {
    const Phase phase = directions[d].phase;
    if (phase == Phase::idle || phase == Phase::restarts || phase == Phase::broken_off)
        return directions[d].at;
    const LinkPackets::Stream& stream = packets.streams[d];
    return phase == Phase::travels && !stream.acknowledge ? stream.due : stream.last_start;
}

/// Withdraws the next packet. If it waited for its wire, keeps the end of the packet ahead of it as an arrival, because
/// the link is busy until then.
void LinkState::stop(std::size_t d, Phase phase) {
    directions[d].at = may_start(d);
    directions[d].phase = phase;
    LinkPackets::Stream& stream = packets.streams[d];
    const std::size_t wire = packets.wire_of(d);
    if (stream.due <= packets.now && packets.free_at[wire] > packets.now)
        arrivals[silence(wire)] = packets.free_at[wire];
    stream.due = never;
}

void LinkState::expect_last_byte(std::size_t d, const PacketTimes& times) {
    expect(last(d) + std::size_t{expects_last_byte(d)}, later(packets.streams[d].last_start, times.arrival()));
}

void LinkState::drop_last_byte(std::size_t d) {
    Time& younger = arrivals[last(d) + 1];
    (younger != never ? younger : arrivals[last(d)]) = never;
}

bool LinkState::is_unacknowledged(std::size_t d) const {
    switch (directions[d].phase) {
    case Phase::delivered:
    case Phase::unnoticed:
    case Phase::owed:
    case Phase::byte_lost:
    case Phase::acknowledge_lost: return true;
    case Phase::travels: return packets.streams[d].acknowledge;
    default: return false;
    }
}

Time LinkState::runs_before(std::size_t d, const PacketTimes& times) const {
    const Direction& direction = directions[d];
    const LinkPackets::Stream& stream = packets.streams[d];
    if (!stream.flows())
        return direction.phase == Phase::unnoticed || direction.phase == Phase::restarts ? direction.at : never;
    if (direction.sender_is == User::program || direction.receiver_is == User::program || direction.ends != Ends::agree)
        return stream.due;
    const bool first_byte_is_next = !stream.acknowledge && stream.bytes_left == direction.part_bytes;
    return first_byte_is_next && !is_first_byte_foreseen(d, times) ? stream.due : never;
}

} // namespace placedpar::hardware
