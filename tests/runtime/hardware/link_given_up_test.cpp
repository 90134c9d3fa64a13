// Tests the remains of messages that were given up. Nothing arrives later, and a deadlocked run ends with their last
// packets.

#include "runtime/alternation.hpp"
#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/random.hpp"
#include "runtime/recovery.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/hardware/adapter_host.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

struct TwoParts {
    std::uint32_t head = 0, bytes = 1; ///< with a head there are two parts
    WireForm wire_form() const { return head > 0 ? WireForm(head, bytes) : WireForm(bytes); }
};

/// A link with a channel in each direction.
struct TwoWays {
    TwoWays(const LinkTiming& timing, bool every_byte) : link(simulation.add<Link>(timing)) {
        if (every_byte)
            for (LinkDirection* direction : {&link.from_a_to_b(), &link.from_b_to_a()})
                direction->simulate_every_byte();
    }
    Simulation simulation;
    Link& link;
    Channel<TwoParts> there{"there", link.from_a_to_b()}, back{"back", link.from_b_to_a()};
};

/// Returns the time at which a run without receivers deadlocks.
Time end_without_receiver(bool overlapped, bool every_byte) {
    TwoWays ways({.overlapped_acknowledge = overlapped}, every_byte);
    ways.simulation.process("sender", [&] { ways.there.out().output({.bytes = 4}); });
    RunResult result = ways.simulation.run();
    CHECK(result.ending == Ending::stuck);
    return result.time;
}

/// Returns the time at which a run deadlocks in which a byte waits for the other direction's acknowledge, and both
/// messages are given up.
Time end_after_withdrawals(bool every_byte) {
    TwoWays ways({.bits_per_second = 10'000'000}, every_byte);
    TwoParts received;
    ways.simulation.process("sender", [&] { output_or_fail(ways.there.out(), {.bytes = 100}, 1280ns); });
    ways.simulation.process("receiver", [&] { ways.there.in().input(); });
    ways.simulation.process("sender back", [&] { wait_until(510ns), ways.back.out().output({.bytes = 50}); });
    ways.simulation.process("receiver back", [&] { input_or_fail(ways.back.in(), received, 1510ns); });
    return ways.simulation.run().time;
}

/// Returns the time at which a run deadlocks in which long messages in both directions are given up at the given times.
Time end_after_giving_up(Time there, Time back, bool every_byte) {
    TwoWays ways({}, every_byte);
    constexpr TwoParts megabyte{.bytes = 1'000'000};
    ways.simulation.process("sender", [&] { output_or_fail(ways.there.out(), megabyte, there); });
    ways.simulation.process("sender back", [&] { output_or_fail(ways.back.out(), megabyte, back); });
    ways.simulation.process("receiver", [&] { ways.there.in().input(); });
    ways.simulation.process("receiver back", [&] { ways.back.in().input(); });
    return ways.simulation.run().time;
}

/// Returns how long each wire of a link at 1000 bit/s was occupied. One wire is first used at `later`.
std::vector<Time> occupied_at_1000_bits_per_second(Time later, bool every_byte) {
    TwoWays ways({.bits_per_second = 1000, .wire_delay = 40ms}, every_byte);
    std::vector<Time> occupied;
    ways.simulation.process("sender", [&] { ways.there.out().output({.bytes = 100}); });
    ways.simulation.process("receiver", [&] { ways.there.in().input(); });
    ways.simulation.process("sender back", [&] { wait_for(later), ways.back.out().output({.bytes = 60}); });
    ways.simulation.process("receiver back", [&] { ways.back.in().input(); });
    ways.simulation.process("observer", [&] {
        for (int n = 0; n < 2; ++n) {
            wait_for(4s + later);
            for (const LinkDirection* direction : {&ways.link.from_a_to_b(), &ways.link.from_b_to_a()})
                occupied.push_back(direction->time_occupied());
        }
    });
    ways.simulation.run();
    return occupied;
}

} // namespace

TEST_CASE("a packet that was requested early and is withdrawn leaves the other packet's step") {
    CHECK(end_after_withdrawals(false) == 1610ns);
    CHECK(end_after_withdrawals(true) == 1610ns);
}

// At 10 Mbit/s a byte occupies its wire for 1100 ns. The acknowledge of direction a to b is requested at 520 ns, and
// waits for the byte of the other direction, from 510 ns to 1610 ns.
TEST_CASE("a receiver that leaves a message whose acknowledge waits for its wire leaves the packet on this wire") {
    for (bool every_byte : {false, true}) {
        CAPTURE(every_byte);
        TwoWays ways({.bits_per_second = 10'000'000}, every_byte);
        TwoParts received;
        ways.simulation.process("sender", [&] { ways.there.out().output({.bytes = 100}); });
        ways.simulation.process("receiver", [&] { input_or_fail(ways.there.in(), received, 700ns); });
        ways.simulation.process("sender back",
                                [&] { wait_until(510ns), output_or_fail(ways.back.out(), {.bytes = 50}, 600ns); });
        ways.simulation.process("receiver back", [&] { ways.back.in().input(); });
        RunResult result = ways.simulation.run();
        CHECK(result.ending == Ending::stuck);
        CHECK(result.time == 1610ns);
    }
}

// At 10 Mbit/s, over a wire of 50 ns, the first message arrives at 1150 ns. Its acknowledge has reached the sender at
// 820 ns, and the byte of the second message begins at 1100 ns.
TEST_CASE("a message arrives although the next one is lost and given up before the end of its last byte") {
    for (bool every_byte : {false, true}) {
        CAPTURE(every_byte);
        TwoWays ways({.bits_per_second = 10'000'000, .wire_delay = 50ns}, every_byte);
        ways.link.suffer({.from = 1us, .wire_from_b = false});
        Time arrived{};
        ways.simulation.process("sender", [&] {
            ways.there.out().output({.bytes = 1});
            CHECK(now() == 820ns);
            CHECK_FALSE(output_or_fail(ways.there.out(), {.bytes = 1}, 1120ns));
        });
        ways.simulation.process("receiver", [&] {
            ways.there.in().input();
            arrived = now();
        });
        CHECK(ways.simulation.run().ending == Ending::completed);
        CHECK(arrived == 1150ns);
    }
}

TEST_CASE("a message that its receiver has given up twice does not arrive") {
    for (bool every_byte : {false, true}) {
        CAPTURE(every_byte);
        TwoWays ways({.wire_delay = 5us}, every_byte);
        std::size_t chosen = 0;
        ways.simulation.process("sender", [&] { ways.there.out().output({.head = 1, .bytes = 1}); });
        ways.simulation.process("receiver", [&] {
            TwoParts message; // the second part begins at 10.56 us and is noticed at 15.82 us
            CHECK_FALSE(input_or_fail(ways.there.in(), message, Time{12us}));
            CHECK(reset(ways.there.in()) == 1);
            CHECK_FALSE(input_or_fail(ways.there.in(), message, Time{13us}));
            CHECK(reset(ways.there.in()) == 0);
            wait_until(Time{40us});
            std::vector<Guard> guards{{Guard::input, &ways.there}, {Guard::timeout, nullptr, Time{50us}}};
            chosen = select(guards);
        });
        ways.simulation.run();
        CHECK(chosen == 1);
    }
}

TEST_CASE("a first byte on the wire when the speed changes arrives at the old speed, also if its receiver gives up") {
    for (bool every_byte : {false, true})
        for (Time begin : {0ns, 20ns}) { // before the receiver asks for the byte, or after
            CAPTURE(every_byte);
            CAPTURE(begin.count());
            TwoWays ways({}, every_byte);
            ways.link.suffer({.kind = LinkFault::Kind::slow, .from = 100ns, .factor = 8});
            TwoParts received;
            Time announced{};
            ways.simulation.process("sender", [&] { wait_until(begin), ways.there.out().output({.bytes = 2}); });
            ways.simulation.process("receiver", [&] {
                CHECK_FALSE(input_or_fail(ways.there.in(), received, Time{200ns}));
                CHECK(reset(ways.there.in()) == 0);
                std::vector<Guard> guards{{Guard::input, &ways.there}, {Guard::timeout, nullptr, Time{50us}}};
                CHECK(select(guards) == 0);
                announced = now();
            });
            // This byte begins at the new speed before the receiver gives up.
            ways.simulation.process("sender back", [&] { wait_until(150ns), ways.back.out().output({.bytes = 1}); });
            ways.simulation.process("receiver back", [&] { ways.back.in().input(); });
            ways.simulation.run();
            CHECK(announced == begin + 550ns); // 11 bits at the usual speed
        }
}

// The second byte begins 440 ns before the end of virtual time, and its acknowledge 180 ns before. The third byte would
// begin after the end.
TEST_CASE("a message that would pass the end of virtual time, and is given up before, leaves no error") {
    for (bool every_byte : {false, true}) {
        CAPTURE(every_byte);
        TwoWays ways({}, every_byte);
        ways.simulation.process("sender", [&] {
            wait_until(Time::max() - 1us);
            CHECK_FALSE(output_or_fail(ways.there.out(), {.bytes = 100}, Time::max() - 100ns));
        });
        ways.simulation.process("receiver", [&] { ways.there.in().input(); });
        CHECK(ways.simulation.run().ending == Ending::stuck);
    }
}

TEST_CASE("a long message that would pass the end of virtual time ends the run with an error") {
    for (bool every_byte : {false, true}) {
        CAPTURE(every_byte);
        TwoWays ways({}, every_byte);
        ways.simulation.process("sender", [&] {
            wait_until(Time::max() - 1us);
            ways.there.out().output({.bytes = 4'000'000'000});
        });
        ways.simulation.process("receiver", [&] { ways.there.in().input(); });
        CHECK_THROWS_AS(ways.simulation.run(), std::overflow_error);
    }
}

TEST_CASE("a run in which no process receives ends when the first byte has arrived and has been noticed") {
    for (bool every_byte : {false, true}) {
        CHECK(end_without_receiver(true, every_byte) == 550ns);  // 11 bits
        CHECK(end_without_receiver(false, every_byte) == 810ns); // 11 bits, then 5.2
    }
}

TEST_CASE("a run whose long messages are given up ends soon after, as with every byte") {
    for (Time there = 2us; there < 3us; there += 90ns)
        for (Time back = 2us; back < 3us; back += 70ns) {
            Time end = end_after_giving_up(there, back, false);
            REQUIRE(end == end_after_giving_up(there, back, true));
            REQUIRE(end < 4us);
        }
}

TEST_CASE("periods longer than two milliseconds are skipped as shorter ones are") {
    for (Time later = 1ms; later < 120ms; later += 7ms)
        REQUIRE(occupied_at_1000_bits_per_second(later, false) == occupied_at_1000_bits_per_second(later, true));
}

TEST_CASE("a byte that a sender gives up while an adapter's program fetches it is not read") {
    constexpr int count = 200;
    for (std::uint64_t seed : test::seeds(40, 1)) {
        INFO(test::replay(seed));
        // At 100 kbit/s the next byte is still arriving when the program has read a byte.
        bool slow = seed % 2 == 0;
        test::Host host(32, slow ? LinkTiming{.bits_per_second = 100'000} : test::adapter_timing);
        RandomStream random(seed, "patience");
        Channel<TwoParts> c("c", host.driver.from_link()), other_way("other way", host.driver.to_link());
        int sent = 0, received = 0;
        host.simulation.process(
            "sender",
            [&] {
                for (int n = 0; n < count; ++n)
                    if (output_or_fail(c.out(), {.head = 1, .bytes = 2},
                                       now() + std::chrono::nanoseconds{1 + random.below(slow ? 1'000'000 : 60'000)}))
                        ++sent;
                    else
                        reset(c.out());
            },
            &host.t800);
        host.simulation.process(
            "receiver",
            [&] {
                TwoParts message;
                for (int in_vain = 0; in_vain < 20;)
                    if (input_or_fail(c.in(), message, now() + 3ms))
                        ++received, in_vain = 0;
                    else
                        reset(c.in()), ++in_vain;
            },
            &host.sun);
        // Bytes in this direction make acknowledges wait for their wire.
        host.simulation.process(
            "sender the other way", [&] { other_way.out().output({.bytes = slow ? 100u : 1000u}); }, &host.sun);
        host.simulation.process(
            "receiver the other way", [&] { other_way.in().input(); }, &host.t800);
        CHECK(host.simulation.run().ending == Ending::completed);
        CHECK(received >= sent);
        CHECK(received < count);
    }
}
