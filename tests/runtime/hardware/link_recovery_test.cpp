// Tests the information that each end gets when a link loses a packet, and the rest of the run.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/random.hpp"
#include "runtime/recovery.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

struct Letter {
    int number = 0;
    std::uint32_t bytes = 1, head = 0; ///< with a head there are two parts
    WireForm wire_form() const { return head > 0 ? WireForm(head, bytes) : WireForm(bytes); }
};

/// Returns the start of each packet of a message: byte, acknowledge, byte, ... At 20 Mbit/s a byte follows every 11.2
/// bits of 50 ns, and its acknowledge begins 5.2 bits later.
Time begin_of(std::uint32_t packet) { return packet / 2 * 560ns + packet % 2 * 260ns; }

struct Told {
    bool sender = false, receiver = false;
    std::uint64_t acknowledged = 0, taken = 0;
    std::vector<int> later; ///< messages received after the resets
    FaultEffect effect;
};

/// Sends a message of this many bytes, of which a fault loses one packet. Both ends give up after 1 ms, reset, and try
/// again.
Told lose_packet(std::uint32_t bytes, std::uint32_t packet, bool every_byte) {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    if (every_byte)
        link.from_a_to_b().simulate_every_byte();
    bool acknowledge = packet % 2 == 1;
    LinkFault fault{.from = begin_of(packet), .until = begin_of(packet) + 1ns};
    (acknowledge ? fault.wire_from_a : fault.wire_from_b) = false;
    const FaultEffect& effect = link.suffer(fault);
    Channel<Letter> c("c", link.from_a_to_b());
    Told told;
    simulation.process("sender", [&] {
        told.sender = output_or_fail(c.out(), Letter{1, bytes}, Time{1ms});
        told.acknowledged = reset(c.out());
        wait_until(2ms);
        c.out().output({2, bytes});
    });
    simulation.process("receiver", [&] {
        Letter letter;
        told.receiver = input_or_fail(c.in(), letter, Time{1ms});
        told.taken = reset(c.in());
        told.later.push_back(c.in().input().number);
    });
    CHECK(simulation.run().ending == Ending::completed);
    told.effect = effect;
    return told;
}

} // namespace

TEST_CASE("a lost byte or acknowledge is an error for both ends, except for a receiver that has all bytes") {
    for (bool every_byte : {true, false})
        for (std::uint32_t bytes = 1; bytes <= 6; ++bytes)
            for (std::uint32_t packet = 0; packet < 2 * bytes; ++packet) {
                CAPTURE(bytes);
                CAPTURE(packet);
                bool acknowledge = packet % 2 == 1, last = packet / 2 + 1 == bytes;
                Told told = lose_packet(bytes, packet, every_byte);
                CHECK(!told.sender);
                CHECK(told.receiver == (acknowledge && last));
                CHECK(told.acknowledged == packet / 2);
                CHECK(told.taken == (told.receiver ? 0 : packet / 2 + acknowledge));
                CHECK(told.later == std::vector{2});
                CHECK(told.effect.bytes_lost == !acknowledge);
                CHECK(told.effect.acknowledges_lost == acknowledge);
                REQUIRE(told.effect.first);
                CHECK(told.effect.first->at == begin_of(packet));
                CHECK(told.effect.first->byte == packet / 2 + 1);
            }
}

TEST_CASE("a lost byte without a time-out is a deadlock that names both processes") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    link.suffer({.from = Time{3us}});
    Channel<Letter> c("c", link.from_a_to_b());
    simulation.process("sender", [&] { c.out().output({1, 100}); });
    simulation.process("receiver", [&] { c.in().input(); });
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::stuck);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->processes.size() == 2);
    CHECK(result.deadlock->held_up.empty()); // no message was given up
}

TEST_CASE("a lost message is a partial deadlock when a time limit ends the run") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    link.suffer({.from = Time{3us}});
    Channel<Letter> c("c", link.from_a_to_b());
    simulation.process("sender", {c.out()}, [&] { c.out().output({1, 100}); });
    simulation.process("receiver", {c.in()}, [&] { c.in().input(); });
    simulation.process("clock", [&] {
        for (;;)
            wait_for(1ms);
    });
    RunResult result = simulation.run(10ms);
    CHECK(result.ending == Ending::time_limit);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->processes.size() == 2);
}

namespace {

/// Returns the report of a run in which one end gives up a message at the given time, resets, and tries again. The
/// other end never resets. Returns "" if nothing is held up.
std::string held_up_after(bool sender_gives_up, Time at, std::uint32_t head, bool every_byte) {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    if (every_byte)
        link.from_a_to_b().simulate_every_byte();
    Channel<Letter> c("c", link.from_a_to_b());
    Letter received;
    simulation.process("sender", [&] {
        if (sender_gives_up && !output_or_fail(c.out(), {1, 1000, head}, at))
            reset(c.out());
        for (;;)
            c.out().output({2, 1000, head});
    });
    simulation.process("receiver", [&] {
        if (!sender_gives_up && !input_or_fail(c.in(), received, at))
            reset(c.in());
        for (int i = 0; i < 3; ++i)
            c.in().input();
    });
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->held_up.size() <= 1);
    return result.deadlock->held_up.empty() ? "" : result.deadlock->held_up.front();
}

} // namespace

TEST_CASE("if only one end of a channel is reset within a message, the report names the other end") {
    for (bool every_byte : {false, true})
        for (std::uint32_t head : {0U, 4U})
            for (Time at : {Time{1us}, Time{2us}, Time{100us}}) {
                CHECK(held_up_after(true, at, head, every_byte) ==
                      "c: waits until receiver, too, gives up its message and resets its end, because sender gave up "
                      "the message in the middle");
                CHECK(held_up_after(false, at, head, every_byte) ==
                      "c: waits until sender, too, gives up its message and resets its end, because receiver gave up "
                      "the message in the middle");
                CHECK(held_up_after(true, Time{1s}, head, every_byte).empty()); // no message is given up
            }
}

TEST_CASE("a sender that gives up before a receiver asks leaves a byte on the link until the receiver resets its end") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<Letter> c("c", link.from_a_to_b());
    simulation.process("sender", [&] {
        CHECK(!output_or_fail(c.out(), Letter{1, 10}, Time{10us}));
        CHECK(reset(c.out()) == 0);
        CHECK(!output_or_fail(c.out(), Letter{2, 10}, Time{50us})); // the byte on the link blocks this output
        CHECK(reset(c.out()) == 0);
        wait_until(100us);
        CHECK(!output_or_fail(c.out(), Letter{3, 10}, Time{200us}));
    });
    simulation.process("receiver", [&] {
        wait_until(30us);
        bool chosen = false;
        alt(on(c.in(), [&](const Letter&) { chosen = true; }), after(Time{31us}, [] {}));
        CHECK(!chosen);
    });
    CHECK(simulation.run().ending == Ending::stuck); // the byte made the guard ready, but the input then waits for ever

    Simulation again;
    Link& other = again.add<Link>();
    Channel<Letter> d("d", other.from_a_to_b());
    again.process("sender", [&] {
        CHECK(!output_or_fail(d.out(), Letter{1, 10}, Time{10us}));
        reset(d.out());
        wait_until(100us);
        CHECK(output_or_fail(d.out(), Letter{3, 10}, Time{200us}));
    });
    again.process("receiver", [&] {
        wait_until(30us);
        CHECK(reset(d.in()) == 1);
        CHECK(d.in().input().number == 3);
    });
    CHECK(again.run().ending == Ending::completed);
}

TEST_CASE("an end that gave up a message refuses the next one until it is reset") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<Letter> c("c", link.from_a_to_b());
    simulation.process("sender", [&] {
        output_or_fail(c.out(), Letter{}, Time{1us});
        c.out().output({});
    });
    CHECK_THROWS_WITH_AS(
        simulation.run(),
        "process sender outputs to channel c, on which it gave up a message: reset this end of the channel first",
        std::logic_error);
}

TEST_CASE("a processor that halts executes nothing more, and its neighbours wait for it") {
    Simulation simulation;
    Processor& halting = simulation.add<Processor>("halting");
    Processor& other = simulation.add<Processor>("other");
    halting.halt_at(1ms);
    Link& link = simulation.add<Link>();
    link.suffer({.from = Time{1ms}, .wire_from_b = false});
    Channel<int> c("c", link.from_a_to_b());
    int steps = 0, received = 0;
    simulation.process(
        "steps",
        [&] {
            for (;;)
                compute(Cycles{1000}), ++steps, c.out().output(steps);
        },
        &halting);
    simulation.process(
        "delayed", [&] { wait_until(1ms), steps = 1000; }, &halting, Priority::high);
    simulation.process(
        "receives",
        [&] {
            for (;;)
                received = c.in().input();
        },
        &other);
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::stuck);
    CHECK(steps == received);
    CHECK(steps > 15);
    CHECK(steps < 20);
    CHECK(halting.time_busy() <= 1ms);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->processes[0].activity == Activity::halted);
    CHECK(result.deadlock->processes[2].activity == Activity::inputting);
}

TEST_CASE("a processor that halts during a computation is busy until it halts") {
    for (Priority priority : {Priority::low, Priority::high}) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        t800.halt_at(300us);
        int ended = 0;
        for (int i = 0; i < 2; ++i)
            simulation.process(
                "computes", [&] { compute(Cycles{4000}), ++ended; }, &t800, priority);
        CHECK(simulation.run().ending == Ending::stuck);
        CHECK(t800.time_busy() == 300us);
        CHECK(ended == 1);
    }
}

namespace {

/// Pairs of processes over links with random faults. Each end may give up, after a time-out or when a third process
/// tells it to, and then resets. Some ends never give up. Each message that its sender knows to be sent must have
/// arrived, once and in order.
class RandomProgram {
public:
    RandomProgram(std::uint64_t seed, bool every_byte) : random_(seed, "recovery over links") {
        bool placed = random_.chance(0.5);
        for (std::size_t i = 0, n = 1 + random_.below(3); i < n; ++i) {
            Link& link = simulation_.add<Link>(LinkTiming{
                .wire_delay = random_.chance(0.5) ? Time{} : Time{std::chrono::nanoseconds{random_.below(900)}},
                .overlapped_acknowledge = random_.chance(0.7)});
            if (every_byte)
                link.from_a_to_b().simulate_every_byte(), link.from_b_to_a().simulate_every_byte();
            add_faults(link);
            Processor* a = placed ? &simulation_.add<Processor>("a") : nullptr;
            Processor* b = placed ? &simulation_.add<Processor>("b") : nullptr;
            bool halts = placed && random_.chance(0.2);
            if (halts)
                a->halt_at(std::chrono::nanoseconds{random_.below(300'000)});
            add_pair(link.from_a_to_b(), a, b);
            if (random_.chance(0.6))
                add_pair(link.from_b_to_a(), b, a), pairs_.back().receiver_halts = halts;
        }
    }

    RunResult run() { return simulation_.run(20ms); }
    void check() const {
        for (const Pair& pair : pairs_) {
            for (int number : pair.told)
                CHECK((pair.receiver_halts || std::ranges::count(pair.received, number) == 1));
            CHECK(std::ranges::is_sorted(pair.received, std::less_equal<>{}));
        }
    }
    std::size_t given_up() const { return given_up_; }

private:
    struct Pair {
        explicit Pair(std::string name) : channel(name), kill("kill " + name) {}
        Channel<Letter> channel;
        Channel<int> kill;
        bool receiver_halts = false; ///< the receiver may get a message and halt before it can say so
        std::vector<int> told, received;
    };

    void add_faults(Link& link) {
        for (std::uint32_t i = 0, n = random_.below(4); i < n; ++i) {
            LinkFault fault{.from = std::chrono::nanoseconds{random_.below(200'000)}};
            fault.kind = std::array{LinkFault::Kind::silent, LinkFault::Kind::loses_acknowledge,
                                    LinkFault::Kind::slow}[random_.below(3)];
            fault.factor = 1 + random_.below(5);
            if (random_.chance(0.9))
                fault.until = fault.from + std::chrono::nanoseconds{1 + random_.below(30'000)};
            if (random_.chance(0.6))
                (random_.chance(0.5) ? fault.wire_from_a : fault.wire_from_b) = false;
            link.suffer(fault);
        }
    }

    void add_pair(Carrier& direction, Processor* from, Processor* to) {
        Pair& pair = pairs_.emplace_back(fmt::format("pair {}", pairs_.size()));
        pair.channel.put_on(direction);
        auto seed = random_.below(1'000'000);
        simulation_.process(
            "sender", [this, &pair, seed] { send(pair, RandomStream(seed, "sender")); }, from, some_priority());
        simulation_.process(
            "receiver", [this, &pair, seed] { receive(pair, RandomStream(seed, "receiver")); }, to, some_priority());
        if (from && random_.chance(0.5))
            simulation_.process(
                "computes", [] { compute(Cycles{5000}); }, from);
    }

    Priority some_priority() { return random_.chance(0.5) ? Priority::high : Priority::low; }
    static Time soon(RandomStream& random) { return now() + std::chrono::nanoseconds{random.below(30'000)}; }
    static void pause(RandomStream& random) {
        if (random.chance(0.5))
            wait_for(std::chrono::nanoseconds{random.below(15'000)});
    }

    void send(Pair& pair, RandomStream random) {
        for (int number = 0; number < 12; ++number) {
            pause(random);
            Letter letter{number, 1 + random.below(random.chance(0.5) ? 3 : 60), random.below(3)};
            if (random.chance(0.01)) {
                pair.channel.out().output(letter);
                pair.told.push_back(number);
            } else if (try_output(pair, letter, random)) {
                pair.told.push_back(number);
            } else {
                ++given_up_;
                pause(random);
                reset(pair.channel.out());
            }
        }
    }
    static bool try_output(Pair& pair, const Letter& letter, RandomStream& random) {
        Time deadline = soon(random);
        if (random.chance(0.7))
            return output_or_fail(pair.channel.out(), letter, deadline);
        // A process in parallel with the sender tells it to give up, as in the toolset.
        bool gone = false;
        Channel<int> stop("stop");
        par(
            [&] {
                gone = output_or_fail(pair.channel.out(), letter, pair.kill.in()),
                gone ? static_cast<void>(pair.kill.in().input()) : void();
            },
            [&] { wait_until(deadline), pair.kill.out().output(1); });
        return gone;
    }

    void receive(Pair& pair, RandomStream random) {
        for (int times = 0; times < 40; ++times) {
            pause(random);
            Letter letter;
            if (random.chance(0.04) &&
                alt(on(pair.channel.in(), [&](const Letter& it) { pair.received.push_back(it.number); }),
                    after(soon(random), [] {})) == 0)
                continue;
            if (input_or_fail(pair.channel.in(), letter, soon(random))) {
                pair.received.push_back(letter.number);
            } else {
                ++given_up_;
                if (random.chance(0.5))
                    pause(random);
                reset(pair.channel.in());
            }
        }
    }

    Simulation simulation_;
    RandomStream random_;
    std::deque<Pair> pairs_;
    std::size_t given_up_ = 0;
};

} // namespace

TEST_CASE("random programs over links with faults end completed or diagnosed, with correct information at both ends") {
    constexpr std::size_t programs = test::sanitized ? 300 : 1500;
    std::size_t given_up = 0, completed = 0, stuck = 0;
    for (std::uint64_t seed : test::seeds(programs)) {
        INFO(test::replay(seed));
        RandomProgram bytes(seed, true), closed(seed, false);
        RunResult result = bytes.run(), with_closed_form = closed.run();
        REQUIRE(result.ending != Ending::time_limit);
        REQUIRE(result.ending == with_closed_form.ending);
        REQUIRE(result.time == with_closed_form.time);
        REQUIRE(result.fingerprint == with_closed_form.fingerprint);
        bytes.check(), closed.check();
        if (result.ending == Ending::stuck)
            REQUIRE(!result.deadlock->processes.empty());
        given_up += bytes.given_up();
        ++(result.ending == Ending::completed ? completed : stuck);
    }
    if (test::all_seeds()) {
        CHECK(given_up > 6 * programs);
        CHECK(completed > programs / 5);
        CHECK(stuck > programs / 15);
    }
}
