#include "runtime/hardware/link_state.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

namespace {

constexpr std::uint8_t order_of(EventQueue::Priority priority, std::size_t rank) {
    return static_cast<std::uint8_t>(priority * LinkState::ranks + rank);
}

/// The order of the packets of one direction among simultaneous steps. If a byte and an acknowledge can begin on the
/// same wire, the acknowledge goes first, even if it waited for the wire. begin_next() in link_period.cpp must follow
/// the same rule.
struct Orders {
    std::uint8_t acknowledge, acknowledge_that_waited, byte;
};
constexpr std::array<Orders, 2> orders{{
    {order_of(EventQueue::request, 1), order_of(EventQueue::start, 4), order_of(EventQueue::start, 1)},
    {order_of(EventQueue::request, 5), order_of(EventQueue::start, 0), order_of(EventQueue::start, 5)},
}};

/// The meaning of an entry of LinkState::arrivals.
struct Arrival {
    LinkStep step;
    std::uint8_t direction, order;
};
constexpr std::array<Arrival, LinkState::most_arrivals> kinds_of_arrivals{{
    {LinkStep::first_byte_arrives, 0, order_of(EventQueue::arrival, 1)},
    {LinkStep::last_byte_arrives, 0, order_of(EventQueue::arrival, 2)},
    {LinkStep::sending_ends, 0, order_of(EventQueue::arrival, 3)},
    {LinkStep::first_byte_arrives, 1, order_of(EventQueue::arrival, 5)},
    {LinkStep::last_byte_arrives, 1, order_of(EventQueue::arrival, 6)},
    {LinkStep::sending_ends, 1, order_of(EventQueue::arrival, 7)},
}};

} // namespace

LinkState::Next LinkState::next_packet(std::size_t d) const {
    const LinkPackets::Stream& stream = packets.streams[d];
    const auto direction = static_cast<std::uint8_t>(d);
    if (!stream.flows()) {
        const Phase phase = directions[d].phase;
        if (phase == Phase::unnoticed)
            return {LinkStep::byte_is_noticed, direction, orders[d].acknowledge, directions[d].at};
        if (phase == Phase::restarts)
            return {LinkStep::register_is_free, direction, orders[d].byte, directions[d].at};
        return {.direction = direction};
    }
    const Time begin = packets.begin_of_next(d);
    if (!stream.acknowledge)
        return {LinkStep::byte_begins, direction, orders[d].byte, begin};
    const bool waited = stream.due < begin;
    return {LinkStep::acknowledge_begins, direction, waited ? orders[d].acknowledge_that_waited : orders[d].acknowledge,
            begin};
}

LinkState::Next LinkState::next() const {
    const Next forth = next_packet(0), back = next_packet(1);
    Next next = back.at < forth.at || (back.at == forth.at && back.order < forth.order) ? back : forth;
    const std::size_t arrival = first_arrival();
    if (arrivals[arrival] < next.at) {
        const Arrival& kind = kinds_of_arrivals[arrival];
        next = {kind.step, kind.direction, kind.order, arrivals[arrival]};
    }
    if (next.at == never && busy_until > packets.now)
        next.at = busy_until; // the link falls silent
    return next;
}

/// Returns the index of the earliest arrival. The loop has no branches, because the host processor could not predict
/// them.
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
    case LinkStep::falls_silent: break;
    }
    return {};
}

/// Begins a byte. If a receiver waits for the first byte of a part, acknowledges are overlapped and packets cannot be
/// lost, the arrival of this byte changes nothing. It is then left out, which saves a step.
LinkState::Outcome LinkState::begin_byte(std::size_t d, const PacketTimes& times, Fate fate) {
    Direction& direction = directions[d];
    LinkPackets::Stream& stream = packets.streams[d];
    packets.begin(times, d);
    if (fate == Fate::is_lost || direction.ends != Ends::agree) {
        direction.phase = Phase::byte_lost;
        stream.due = never;
        return {.is_lost = true};
    }
    const bool is_first = stream.bytes_left + 1 == direction.part_bytes;
    if (is_first && !is_first_byte_foreseen(d, times))
        expect_first_byte(d, times);
    if (users[d].receiver == User::program || (is_first && !is_sure_of_receiver(d))) {
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
    if (fate == Fate::is_lost) {
        direction.phase = Phase::acknowledge_lost;
        stream.due = never;
        return {.delivers = delivers, .is_lost = true};
    }
    if (is_last)
        arrivals[end_of_sending(d)] = time_of_step(packets.now, times.acknowledge_arrival());
    if (is_last || users[d].sender == User::program) {
        direction.phase = users[d].sender == User::program ? Phase::restarts : Phase::idle;
        direction.at = std::exchange(stream.due, never);
    }
    return {.delivers = delivers};
}

/// Handles the arrival of a part's last byte. If the acknowledge of this byte has begun, the part was handed over at
/// that time. If the next part has begun, the acknowledge has certainly begun, too.
LinkState::Outcome LinkState::last_byte_arrives(std::size_t d) {
    Direction& direction = directions[d];
    const LinkPackets::Stream& stream = packets.streams[d];
    arrivals[last(d)] = std::exchange(last_bytes_after[d], never);
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

/// Withdraws the next packet. If this packet waited for its wire, the link stays busy until the other packet on that
/// wire ends.
void LinkState::stop(std::size_t d, Phase phase) {
    directions[d].at = may_start(d);
    directions[d].phase = phase;
    LinkPackets::Stream& stream = packets.streams[d];
    if (stream.due <= packets.now)
        busy_until = std::max(busy_until, packets.free_at[packets.wire_of(d)]);
    stream.due = never;
}

void LinkState::expect_last_byte(std::size_t d, const PacketTimes& times) {
    (expects_last_byte(d) ? last_bytes_after[d] : arrivals[last(d)]) =
        time_of_step(packets.streams[d].last_start, times.arrival());
}

void LinkState::drop_last_byte(std::size_t d) {
    (last_bytes_after[d] != never ? last_bytes_after[d] : arrivals[last(d)]) = never;
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
    if (users[d].sender == User::program || users[d].receiver == User::program || direction.ends != Ends::agree)
        return stream.due;
    const bool first_byte_is_next = !stream.acknowledge && stream.bytes_left == direction.part_bytes;
    return first_byte_is_next && !is_first_byte_foreseen(d, times) ? stream.due : never;
}

} // namespace placedpar::hardware
