// Tests the cores of a native run in cases computed by hand.

#include "runtime/hardware/core.hpp"

#include "runtime/channel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

constexpr CoreCosts costs_of_core{.communication = Cycles{10},
                                  .crossing = Cycles{300},
                                  .switching = Cycles{40},
                                  .patience = Cycles{20'000},
                                  .waking = Cycles{50'000}};

/// Two processes on two cores, or on one, with a channel there and back.
struct CorePair {
    explicit CorePair(bool on_two, std::int64_t bytes_per_second = 1'000'000'000)
        : a(simulation.add<ComputerCore>("a", costs_of_core)),
          b(on_two ? simulation.add<ComputerCore>("b", costs_of_core) : a),
          forth(simulation.add<CoreLane>(b, bytes_per_second)),
          back_lane(simulation.add<CoreLane>(a, bytes_per_second)) {
        if (on_two) {
            there.put_on(forth);
            back.put_on(back_lane);
        }
    }
    /// Returns the time of the last of these rounds.
    Time last_round(int rounds, Time pause = {}) {
        Time took{};
        simulation.process(
            "ping",
            [&, rounds, pause] {
                for (int i = 0; i < rounds; ++i) {
                    if (pause > Time{})
                        wait_for(pause);
                    const Time begun = now();
                    there.out().output(std::vector<char>(bytes));
                    back.in().input();
                    took = now() - begun;
                }
            },
            &a);
        simulation.process(
            "pong",
            [&, rounds] {
                for (int i = 0; i < rounds; ++i)
                    back.out().output(there.in().input());
            },
            &b);
        simulation.run();
        return took;
    }

    Simulation simulation;
    ComputerCore &a, &b;
    CoreLane &forth, &back_lane;
    Channel<std::vector<char>> there{"there"}, back{"back"};
    std::size_t bytes = 0;
};

} // namespace

TEST_CASE("a message there and back on a core is four inputs or outputs, and two switches") {
    CHECK(CorePair(false).last_round(10) == 4 * 10ns + 2 * 40ns);
}

TEST_CASE("a message there and back between cores is two crossings one after the other, and two switches") {
    CorePair pair(true, 1'000'000'000'000);
    CHECK(pair.last_round(10) == 2 * 300ns + 2 * 40ns);
}

TEST_CASE("the inputter pays for the bytes of a message between cores") {
    CorePair small(true), large(true);
    large.bytes = 5000;
    CHECK(large.last_round(10) - small.last_round(10) == 2 * 5000ns);
}

TEST_CASE("a core that has had nothing to do for longer than its patience takes time to wake") {
    CorePair awake(true, 1'000'000'000'000), asleep(true, 1'000'000'000'000);
    const Time near = awake.last_round(10, 15us), far = asleep.last_round(10, 200us);
    CHECK(far - near == 2 * 50us); // pong wakes, and ping has fallen asleep meanwhile
}

TEST_CASE("a core that no message wakes finds it at the end of a pause") {
    CoreCosts rank = costs_of_core;
    rank.waking = Cycles{0};
    rank.oversleeping = Cycles{5'000};
    // The pauses of a rank that waits end at 20, 45, 70, 95, 120, 145, 170, 195.25 us and so on: each lasts an eighth
    // of the time before it, at least 20 us, and 5 us more.
    const auto input_of = [&](Time sent) {
        Simulation simulation;
        auto &a = simulation.add<ComputerCore>("a", CoreCosts{}), &b = simulation.add<ComputerCore>("b", rank);
        Channel<int> channel("c");
        channel.put_on(simulation.add<CoreLane>(b, 1'000'000'000'000));
        Time input{};
        const auto send = [&] {
            wait_for(sent);
            channel.out().output(1);
        };
        const auto receive = [&] {
            channel.in().input();
            input = now();
        };
        simulation.process("sender", send, &a);
        simulation.process("receiver", receive, &b);
        simulation.run();
        return input;
    };
    for (const auto& [sent, found] : {std::pair(15us, 15us), std::pair(21us, 45us), std::pair(69us, 70us)}) {
        CHECK(input_of(sent) >= Time(found));
        CHECK(input_of(sent) < Time(found) + 2us);
    }
}

TEST_CASE("no process of a core interrupts another, whatever their priorities and however long they compute") {
    Simulation simulation;
    ComputerCore& core = simulation.add<ComputerCore>("c", CoreCosts{});
    Channel<int> begin("begin");
    std::vector<std::string> order;
    const auto computing = [&](const char* name) {
        return [&order, name] {
            compute(Cycles{100'000'000}); // a hundred times a transputer's timeslice
            order.emplace_back(name);
        };
    };
    simulation.process("first", computing("first"), &core);
    simulation.process("second", computing("second"), &core);
    simulation.process("urgent", computing("urgent"), &core, Priority::high);
    CHECK(simulation.run().time == 300ms);
    CHECK(order == std::vector<std::string>{"first", "second", "urgent"});
    CHECK(core.time_busy() == 300ms);
}

TEST_CASE("a process that another core has woken does not wait for the others that are ready") {
    CorePair pair(true, 1'000'000'000'000);
    for (int i = 0; i < 10; ++i)
        pair.simulation.process(
            "busy" + std::to_string(i),
            [] {
                for (int turn = 0; turn < 50; ++turn) {
                    compute(Cycles{1'000'000});
                    wait_for(1ns);
                }
            },
            &pair.b);
    // Ten processes compute for a millisecond in turn, but at most one of them comes before each of the two turns of
    // pong.
    CHECK(pair.last_round(10) < 3ms);
}

TEST_CASE("a process that is always ready has a turn after eight turns of processes that another core wakes") {
    Simulation simulation;
    auto &a = simulation.add<ComputerCore>("a", CoreCosts{}), &b = simulation.add<ComputerCore>("b", CoreCosts{});
    CoreLane& lane = simulation.add<CoreLane>(b, 1'000'000'000'000);
    constexpr int pairs = 20, messages = 100;
    std::deque<Channel<int>> channels;
    for (int i = 0; i < pairs; ++i) {
        Channel<int>& channel = channels.emplace_back("c");
        channel.put_on(lane);
        const auto send = [&] {
            for (int j = 0; j < messages; ++j) {
                wait_for(50us); // meanwhile the receiver waits, and the others compute
                channel.out().output(j);
            }
        };
        const auto receive = [&] {
            for (int j = 0; j < messages; ++j) {
                channel.in().input();
                compute(Cycles{10'000});
            }
        };
        simulation.process("sender", send, &a);
        simulation.process("receiver", receive, &b);
    }
    Time took{};
    const auto busy = [&] {
        wait_for(1ms);
        const Time begun = now();
        for (int turn = 0; turn < 10; ++turn)
            wait_for(1ns); // gives the others a turn
        took = now() - begun;
    };
    simulation.process("busy", busy, &b);
    CHECK(simulation.run().time >= pairs * messages * 10us); // the receivers keep the core busy
    CHECK(took >= 10 * 7 * 10us);
    CHECK(took <= 10 * 8 * 10us);
}

TEST_CASE("a core refuses costs without sense") {
    Simulation simulation;
    CHECK_THROWS_AS(simulation.add<ComputerCore>("c", CoreCosts{.clock_hz = 0}), std::logic_error);
    CHECK_THROWS_AS(simulation.add<ComputerCore>("c", CoreCosts{.waking = Cycles{-1}}), std::logic_error);
}
