// Tests a link's state and packets as values, without a kernel, against times computed by hand.
//
// At 20 Mbit/s a bit takes 50 ns, and the wire delays it by 40 ns. A byte occupies the wire for 550 ns and has arrived
// after 590 ns. It is noticed after 5.2 bits and the wire's delay: 300 ns. Its acknowledge then occupies the wire for
// 100 ns and has arrived after 140 ns. The next byte begins 340 ns after the start of the acknowledge: 3.6 bits, 120
// ns, and the wire's delay. So bytes follow each other every 640 ns.

#include "runtime/hardware/link_period.hpp"
#include "runtime/hardware/link_state.hpp"
#include "runtime/random.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

using Phase = LinkState::Phase;
using Receiver = LinkState::Receiver;

const PacketTimes usual(LinkTiming{.wire_delay = 40ns});

struct Step {
    LinkStep step;
    std::size_t direction;
    std::chrono::nanoseconds at;
    bool operator==(const Step&) const = default;
};
using Steps = std::vector<Step>;

Step shown(const LinkState::Next& next) {
    return {next.step, next.direction, std::chrono::duration_cast<std::chrono::nanoseconds>(next.at)};
}

LinkState::Outcome take_next(LinkState& state, LinkState::Fate fate = LinkState::Fate::comes_over) {
    return state.perform(state.next(), usual, fate);
}

/// Performs all remaining steps and returns them.
Steps drain(LinkState& state) {
    Steps steps;
    for (LinkState::Next next; (next = state.next()).at != never && steps.size() < 100;) {
        steps.push_back(shown(next));
        state.perform(next, usual);
    }
    return steps;
}

/// Begins a part.
void begin_part(LinkState& state, std::size_t direction, std::uint32_t bytes, Receiver receiver) {
    state.directions[direction].part_bytes = state.packets.streams[direction].bytes_left = bytes;
    state.directions[direction].receiver = receiver;
    state.ask_for_byte(direction, state.packets.now);
}

} // namespace

TEST_CASE("link state: a part of two bytes to a receiver that waits takes the steps computed by hand") {
    LinkState state;
    begin_part(state, 1, 2, Receiver::waits);
    CHECK(drain(state) == Steps{{LinkStep::byte_begins, 1, 0ns},
                                {LinkStep::acknowledge_begins, 1, 300ns},
                                {LinkStep::byte_begins, 1, 640ns},
                                {LinkStep::acknowledge_begins, 1, 940ns},
                                {LinkStep::sending_ends, 1, 1080ns},
                                {LinkStep::last_byte_arrives, 1, 1230ns}});
    CHECK(state.directions[1].phase == Phase::idle);
    CHECK(state.directions[1].receiver == Receiver::absent);
    CHECK(state.may_start(1) == 1280ns);
}

TEST_CASE("link state: a receiver has a part from its last acknowledge on, and continues when its last byte arrives") {
    LinkState state;
    begin_part(state, 0, 1, Receiver::waits);
    CHECK(state.runs_before(0, usual) == never); // only the times of the byte must be computed
    CHECK(!take_next(state).delivers);
    CHECK(!state.expects_first_byte(0)); // its arrival has no visible effect
    LinkState::Outcome acknowledge = take_next(state);
    CHECK(acknowledge.delivers);
    CHECK(!acknowledge.wakes);
    take_next(state); // sending ends
    LinkState::Outcome last_byte = take_next(state);
    CHECK(!last_byte.delivers);
    CHECK(last_byte.wakes);
}

TEST_CASE("link state: without overlap a byte arrives before it is acknowledged") {
    const PacketTimes in_turn(LinkTiming{.wire_delay = 40ns, .overlapped_acknowledge = false});
    LinkState state;
    begin_part(state, 0, 1, Receiver::waits);
    state.perform(state.next(), in_turn);
    CHECK(state.expects_first_byte(0));
    CHECK(shown(state.next()) == Step{LinkStep::first_byte_arrives, 0, 590ns});
    state.perform(state.next(), in_turn);
    CHECK(shown(state.next()) == Step{LinkStep::last_byte_arrives, 0, 590ns});
    LinkState::Outcome last_byte = state.perform(state.next(), in_turn);
    CHECK(last_byte.delivers);
    CHECK(last_byte.wakes);
    CHECK(state.directions[0].phase == Phase::delivered);
    CHECK(shown(state.next()) == Step{LinkStep::acknowledge_begins, 0, 850ns});
    CHECK(!state.perform(state.next(), in_turn).delivers);
    CHECK(shown(state.next()) == Step{LinkStep::sending_ends, 0, 990ns});
    CHECK(state.may_start(0) == 850ns + 440ns); // the acknowledge, then the restart as with overlap
}

TEST_CASE("link state: a byte that no receiver has asked for waits without an acknowledge") {
    LinkState state;
    begin_part(state, 0, 1, Receiver::absent);
    CHECK(state.runs_before(0, usual) == 0ns);
    take_next(state);
    CHECK(state.directions[0].phase == Phase::unnoticed);
    CHECK(state.is_unacknowledged(0));
    CHECK(state.runs_before(0, usual) == 300ns);
    CHECK(drain(state) == Steps{{LinkStep::byte_is_noticed, 0, 300ns},
                                {LinkStep::first_byte_arrives, 0, 590ns},
                                {LinkStep::last_byte_arrives, 0, 590ns}});
    CHECK(state.directions[0].phase == Phase::owed);
    CHECK(state.directions[0].first_byte == LinkState::FirstByte::waits);
    CHECK(state.is_unacknowledged(0));
    state.packets.now = 2us;
    state.ask_for_acknowledge(0, Phase::delivered, state.packets.now);
    CHECK(!take_next(state).delivers);
    CHECK(!state.is_unacknowledged(0));
    CHECK(drain(state) == Steps{{LinkStep::sending_ends, 0, 2140ns}});
}

TEST_CASE("link state: a receiver that waits for the last byte of a part has not asked for the next part") {
    LinkState state;
    begin_part(state, 0, 1, Receiver::waits);
    take_next(state), take_next(state), take_next(state);
    REQUIRE(shown(state.next()) == Step{LinkStep::last_byte_arrives, 0, 590ns});
    begin_part(state, 0, 1, Receiver::waits);
    state.ask_for_byte(0, 550ns); // a sender that restarts faster
    take_next(state);
    CHECK(state.directions[0].phase == Phase::unnoticed);
    CHECK(drain(state) == Steps{{LinkStep::last_byte_arrives, 0, 590ns},
                                {LinkStep::byte_is_noticed, 0, 850ns},
                                {LinkStep::first_byte_arrives, 0, 1140ns},
                                {LinkStep::last_byte_arrives, 0, 1140ns}});
}

TEST_CASE("link state: of two packets that wait for one wire the acknowledge goes first") {
    for (std::size_t wire : {0u, 1u})
        for (Time acknowledge_asks : {0ns, 200ns, 500ns})
            for (Time byte_asks : {0ns, 200ns, 500ns}) {
                CAPTURE(wire);
                LinkState state;
                state.directions[wire].part_bytes = state.packets.streams[wire].bytes_left = 1;
                state.packets.free_at[wire] = 500ns;
                state.ask_for_byte(wire, byte_asks);
                state.ask_for_acknowledge(1 - wire, Phase::travels, acknowledge_asks);
                CHECK(shown(state.next()) == Step{LinkStep::acknowledge_begins, 1 - wire, 500ns});
                take_next(state);
                CHECK(shown(state.next_packet(wire)) == Step{LinkStep::byte_begins, wire, 600ns});
            }
}

TEST_CASE("link state: within an instant acknowledges are requested, then packets begin, then packets arrive") {
    auto priority_of_next = [](bool acknowledge, Time asks, std::size_t direction) {
        LinkState state;
        state.directions[direction].part_bytes = state.packets.streams[direction].bytes_left = 1;
        state.packets.free_at = {500ns, 500ns};
        if (acknowledge)
            state.ask_for_acknowledge(direction, Phase::travels, asks);
        else
            state.ask_for_byte(direction, asks);
        return state.next().priority();
    };
    for (std::size_t direction : {0u, 1u}) {
        CHECK(priority_of_next(true, 600ns, direction) == EventQueue::request);
        CHECK(priority_of_next(true, 500ns, direction) == EventQueue::request); // its wire is free
        CHECK(priority_of_next(true, 400ns, direction) == EventQueue::start);   // when its wire becomes free
        CHECK(priority_of_next(false, 600ns, direction) == EventQueue::start);
        CHECK(priority_of_next(false, 400ns, direction) == EventQueue::start);
    }
}

TEST_CASE("link state: simultaneous arrivals and packets are ordered") {
    LinkState state;
    state.arrivals.fill(1us);
    state.last_bytes_after.fill(1us);
    state.ask_for_byte(1, 1us);
    CHECK(shown(state.next()) == Step{LinkStep::byte_begins, 1, 1us});
    state.packets.streams[1].due = never;
    for (LinkState copy = state; copy.next().at != never; take_next(copy))
        CHECK(copy.next().priority() == EventQueue::arrival);
    CHECK(drain(state) == Steps{{LinkStep::first_byte_arrives, 0, 1us},
                                {LinkStep::last_byte_arrives, 0, 1us},
                                {LinkStep::last_byte_arrives, 0, 1us},
                                {LinkStep::sending_ends, 0, 1us},
                                {LinkStep::first_byte_arrives, 1, 1us},
                                {LinkStep::last_byte_arrives, 1, 1us},
                                {LinkStep::last_byte_arrives, 1, 1us},
                                {LinkStep::sending_ends, 1, 1us}});
}

TEST_CASE("link state: of two last bytes on a long wire the older arrives first, and the younger can be dropped") {
    LinkState state;
    state.packets.streams[0].last_start = 100ns;
    state.expect_last_byte(0, usual);
    state.packets.streams[0].last_start = 700ns;
    state.expect_last_byte(0, usual);
    LinkState without_younger = state, without_both = state;
    CHECK(drain(state) == Steps{{LinkStep::last_byte_arrives, 0, 690ns}, {LinkStep::last_byte_arrives, 0, 1290ns}});
    without_younger.drop_last_byte(0);
    CHECK(drain(without_younger) == Steps{{LinkStep::last_byte_arrives, 0, 690ns}});
    without_both.drop_last_bytes(0);
    CHECK(drain(without_both).empty());
}

TEST_CASE("link state: a withdrawn packet that was due leaves the end of the packet on its wire") {
    auto left_of = [](Time asks, Time wire_is_free) {
        LinkState state;
        state.packets.now = 400ns;
        state.packets.free_at = {wire_is_free, 0ns};
        state.ask_for_acknowledge(1, Phase::travels, asks);
        state.stop(1, Phase::idle);
        return drain(state);
    };
    CHECK(left_of(300ns, 500ns) == Steps{{LinkStep::falls_silent, 0, 500ns}});
    CHECK(left_of(400ns, 500ns) == Steps{{LinkStep::falls_silent, 0, 500ns}});
    CHECK(left_of(450ns, 500ns).empty());
    CHECK(left_of(400ns, 400ns).empty());
}

TEST_CASE("link state: no packet follows a lost packet") {
    LinkState state;
    state.may_lose_packets = true;
    begin_part(state, 0, 1, Receiver::waits);
    LinkState acknowledge_lost = state;

    LinkState::Outcome byte = take_next(state, LinkState::Fate::is_lost);
    CHECK(byte.is_lost);
    CHECK(!byte.delivers);
    CHECK(state.directions[0].phase == Phase::byte_lost);
    CHECK(state.is_unacknowledged(0));
    CHECK(drain(state).empty());

    take_next(acknowledge_lost);
    LinkState::Outcome acknowledge = take_next(acknowledge_lost, LinkState::Fate::is_lost);
    CHECK(acknowledge.is_lost);
    CHECK(acknowledge.delivers);
    CHECK(acknowledge_lost.directions[0].phase == Phase::acknowledge_lost);
    CHECK(acknowledge_lost.is_unacknowledged(0));
    CHECK(drain(acknowledge_lost) ==
          Steps{{LinkStep::first_byte_arrives, 0, 590ns}, {LinkStep::last_byte_arrives, 0, 590ns}});
}

TEST_CASE("link state: a program writes the next byte when its register is free, and reads each byte itself") {
    LinkState state;
    state.users[0] = {LinkState::User::program, LinkState::User::program};
    begin_part(state, 0, 2, Receiver::waits);
    CHECK(state.runs_before(0, usual) == 0ns);
    take_next(state), take_next(state); // the byte begins and is noticed
    CHECK(state.directions[0].phase == Phase::owed);
    state.ask_for_acknowledge(0, Phase::travels, state.packets.now);
    take_next(state);
    CHECK(state.directions[0].phase == Phase::restarts);
    CHECK(state.may_start(0) == 640ns);
    CHECK(state.runs_before(0, usual) == 640ns);
    REQUIRE(shown(state.next_packet(0)) == Step{LinkStep::register_is_free, 0, 640ns});
    state.perform(state.next_packet(0), usual);
    CHECK(state.directions[0].phase == Phase::idle);
}

TEST_CASE("link state: the first step that would come after the end of virtual time is too late") {
    auto steps_in_time = [](Time before_the_end) {
        LinkState state;
        state.packets.now = never - before_the_end;
        begin_part(state, 0, 2, Receiver::waits);
        int steps = 0;
        for (; state.next().at < too_late; ++steps)
            take_next(state);
        CHECK(state.next().at == (steps < 6 ? too_late : never));
        return steps;
    };
    int steps = 0;
    for (Time step : {300ns, 640ns, 940ns, 1080ns, 1230ns}) { // the steps after the first, as above
        CHECK(steps_in_time(step - 1ns) == ++steps);
        CHECK(steps_in_time(step + 1ns) == steps + 1);
    }
}

TEST_CASE("link packets: the number of bytes that have begun is known at every moment of a run") {
    constexpr std::uint32_t bytes = 100;
    for (std::size_t direction : {0u, 1u}) {
        LinkState start;
        begin_part(start, direction, bytes, Receiver::waits);
        LinkPackets packets = start.packets;
        const LinkPackets::Stream& stream = packets.streams[direction];
        LinkPeriod period;
        REQUIRE(period.find(packets, usual, {}));
        const Time last = (bytes - 1) * 640ns;
        CHECK(packets.now == last);
        CHECK(stream.bytes_left == 0);
        CHECK(stream.last_start == last);
        CHECK(stream.due == last + 300ns);
        CHECK(packets.free_at[direction] == last + 550ns);
        CHECK(period.length == 640ns);
        CHECK(period.until == last);
        CHECK(!period.is_simple_around(last));
        CHECK(period.since <= 5us);
        for (Time moment = period.since; moment < last; moment += 10ns) {
            REQUIRE(period.is_simple_around(moment) == (moment > period.since));
            REQUIRE(period.bytes_left(direction, moment) == bytes - 1 - moment / 640ns);
            LinkPackets then = start.packets;
            period.replay(then, usual, {.before = moment});
            REQUIRE(then.streams[direction].bytes_left == bytes - (moment + 639ns) / 640ns);
        }
    }
}

TEST_CASE("link packets: a run ends at a last byte, before it if the trace must see it, or before its acknowledge") {
    LinkState start;
    begin_part(start, 0, 3, Receiver::waits);
    LinkPackets up_to_last = start.packets, before_last = start.packets;
    LinkPeriod period;
    CHECK(period.find(up_to_last, usual, {}));
    CHECK(up_to_last.now == 1280ns);
    CHECK(up_to_last.streams[0].bytes_left == 0);
    CHECK(!period.find(up_to_last, usual, {}));
    CHECK(period.find(before_last, usual, {.last_bytes_stop = true}));
    CHECK(before_last.now == 940ns); // the second byte's acknowledge
    CHECK(before_last.streams[0].bytes_left == 1);
    CHECK(!period.find(before_last, usual, {.last_bytes_stop = true}));
}

/// Returns how many bytes have begun in two directions. They begin bytes at `first` and `second`, and then every 1780
/// ns.
std::int64_t begun_by(Time moment, Time first, Time second) {
    auto of = [moment](Time start) { return moment < start ? 0 : 1 + (moment - start) / 1780ns; };
    return of(first) + of(second);
}

// Wire 0 carries the first byte of direction 0 until 550, then the other direction's acknowledge. The second byte of
// direction 1 begins at 890. Wire 1 carries the first byte of direction 1 from 100 to 650. The second byte of direction
// 0 begins at 990. Now direction 1 is as far ahead as it was behind, so the directions change places. After two bytes,
// 1780 ns, the initial state returns.
TEST_CASE("link packets: two busy directions that begin 100 ns apart repeat after two bytes") {
    LinkState start;
    begin_part(start, 0, 100, Receiver::waits);
    begin_part(start, 1, 60, Receiver::waits);
    start.packets.streams[1].due = 100ns;
    LinkPackets packets = start.packets;
    LinkPeriod period;
    REQUIRE(period.find(packets, usual, {}));
    CHECK(period.length == 1780ns);
    const Time last = 890ns + 29 * 1780ns; // start of the sixtieth byte of direction 1
    CHECK(packets.now == last);
    CHECK(packets.streams[0].bytes_left == 41);
    CHECK(packets.streams[0].last_start == 29 * 1780ns);
    CHECK(packets.streams[1].bytes_left == 0);
    CHECK(packets.free_at == std::array<Time, 2>{29 * 1780ns + 650ns, last + 550ns});
    CHECK(period.until == last);
    for (Time moment = period.since; moment < last; moment += 10ns) {
        REQUIRE(period.is_simple_around(moment) == (moment > period.since));
        REQUIRE(period.bytes_left(0, moment) == 100 - begun_by(moment, 0ns, 990ns));
        REQUIRE(period.bytes_left(1, moment) == 60 - begun_by(moment, 100ns, 890ns));
    }
    for (Time before{}; before <= last; before += 10ns) {
        LinkPackets then = start.packets;
        period.replay(then, usual, {.before = before});
        REQUIRE(then.streams[0].bytes_left == 100 - begun_by(before - Time{1}, 0ns, 990ns));
        REQUIRE(then.streams[1].bytes_left == 60 - begun_by(before - Time{1}, 100ns, 890ns));
    }
}

namespace {

PacketTimes random_times(RandomStream& random) {
    LinkTiming timing;
    timing.bits_per_second = std::array<std::int64_t, 4>{1000, 5'000'000, 10'000'000, 20'000'000}[random.below(4)];
    timing.wire_delay = random.chance(0.5) ? std::chrono::nanoseconds{random.below(2000)} : Time{};
    timing.overlapped_acknowledge = random.chance(0.7);
    return PacketTimes(timing);
}

/// Returns a direction that is in the middle of a part, at the end of a part, or has nothing to send. Its last byte
/// began before time 0, and the next part is requested within four bytes. Times are whole tenths of a bit, so that many
/// coincide.
LinkPackets::Stream random_stream(RandomStream& random, const PacketTimes& times) {
    LinkPackets::Stream stream;
    if (random.chance(0.1))
        return stream;
    const Time tenth = times.byte().carried / 110;
    stream.acknowledge = random.chance(0.5);
    stream.bytes_left = random.below(random.chance(0.3) ? 4 : 200) + std::uint32_t{!stream.acknowledge};
    stream.due = random.below(440) * tenth;
    return stream;
}

/// Begins the packets one by one.
LinkPackets run_each(LinkPackets packets, const PacketTimes& times, const LinkLimit& limit) {
    LinkPeriod unknown;
    unknown.replay(packets, times, limit);
    return packets;
}

/// Compares everything that has an effect. The time at which a wire became free has no effect if it is in the past.
void check_same(const LinkPackets& one, const LinkPackets& other) {
    REQUIRE(one.now == other.now);
    for (std::size_t d : {0u, 1u}) {
        REQUIRE(std::max(one.free_at[d], one.now) == std::max(other.free_at[d], other.now));
        REQUIRE(one.streams[d].bytes_left == other.streams[d].bytes_left);
        REQUIRE(one.streams[d].due == other.streams[d].due);
        REQUIRE(one.streams[d].last_start == other.streams[d].last_start);
    }
}

} // namespace

// At a distance of 250 ns, the acknowledge of direction 1 waits for the first byte of direction 0. Before the second
// byte, the next packet of direction 1 is again 250 ns away, but it is a byte.
TEST_CASE(
    "link packets: packets repeat only if the same kinds of packets follow, at every distance of the directions") {
    for (std::size_t first : {0u, 1u})
        for (bool acknowledge : {false, true})
            for (Time distance{}; distance <= 1300ns; distance += 5ns) {
                CAPTURE(first);
                CAPTURE(acknowledge);
                CAPTURE(distance.count());
                LinkPackets start;
                start.streams[first] = {.bytes_left = 30, .due = 0ns};
                start.streams[1 - first] = {.bytes_left = 40, .acknowledge = acknowledge, .due = distance};
                LinkPackets found = start;
                LinkPeriod().find(found, usual, {});
                check_same(found, run_each(start, usual, {}));
            }
}

TEST_CASE("link packets: skipped periods have the effect of single packets, from any initial state") {
    int simple = 0;
    for (std::uint64_t seed : test::seeds(2000)) {
        INFO(test::replay(seed));
        RandomStream random(seed, "periods against packets");
        const PacketTimes times = random_times(random);
        LinkPackets start;
        for (LinkPackets::Stream& stream : start.streams)
            stream = random_stream(random, times);
        const LinkLimit limit{.before = random.chance(0.5) ? never : random.below(200) * times.byte().carried,
                              .last_bytes_stop = random.chance(0.2)};
        LinkPackets found = start;
        LinkPeriod period;
        period.find(found, times, limit);
        check_same(found, run_each(start, times, limit));
        CHECK(!period.is_simple_around(later(found.now, Time{1})));
        const std::int64_t grid = random.chance(0.5) ? times.byte().carried.count() / 110 : 1;
        for (int n = 0; n < 20; ++n) {
            const double anywhere = random.uniform() * static_cast<double>(found.now.count() / grid);
            const Time moment{static_cast<std::int64_t>(anywhere) * grid};
            const LinkPackets then = run_each(start, times, {moment, limit.last_bytes_stop});
            LinkPackets run = start;
            period.replay(run, times, {moment, limit.last_bytes_stop});
            check_same(run, then);
            if (!period.is_simple_around(moment))
                continue;
            ++simple;
            REQUIRE(period.bytes_left(0, moment - Time{1}) == then.streams[0].bytes_left);
            REQUIRE(period.bytes_left(1, moment - Time{1}) == then.streams[1].bytes_left);
        }
    }
    CHECK((simple > 1000 || !test::all_seeds()));
}
