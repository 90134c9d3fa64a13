// Tests communications that are given up, on soft channels.

#include "runtime/recovery.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace std::chrono_literals;

TEST_CASE("an output and an input with a time-out fail at the deadline if no partner comes") {
    Simulation simulation;
    Channel<int> nobody("nobody"), never("never");
    int message = 7;
    simulation.process("outputs", [&] {
        CHECK(!output_or_fail(nobody.out(), 1, Time{5us}));
        CHECK(now() == 5us);
        CHECK(reset(nobody.out()) == 0);
        CHECK(!output_or_fail(nobody.out(), 1, Time{1us})); // this time has passed already
        CHECK(now() == 5us);
    });
    simulation.process("inputs", [&] {
        CHECK(!input_or_fail(never.in(), message, Time{6us}));
        CHECK(now() == 6us);
        CHECK(reset(never.in()) == 0);
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(message == 7);
}

TEST_CASE("a message that comes in time is received, and a message that was given up leaves nothing behind") {
    Simulation simulation;
    Channel<int> c("c");
    std::vector<int> received;
    simulation.process("outputs", [&] {
        CHECK(!output_or_fail(c.out(), 1, Time{5us}));
        CHECK(output_or_fail(c.out(), 2, Time{50us}));
        CHECK(now() == 20us);
        wait_until(100us);
        c.out().output(3);
    });
    simulation.process("inputs", [&] {
        wait_until(20us);
        int message = 0;
        CHECK(input_or_fail(c.in(), message, Time{20us}));
        received.push_back(message);
        CHECK(!input_or_fail(c.in(), message, Time{90us}));
        received.push_back(c.in().input());
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(received == std::vector{2, 3});
}

TEST_CASE("a message on the failure channel ends an attempt and is input; otherwise it stays in its channel") {
    for (bool soon : {false, true}) {
        Simulation simulation;
        Channel<int> out("out"), in("in"), kill("kill");
        bool told_in_vain = true;
        simulation.process("outputs", [&] {
            int message = 0;
            CHECK(output_or_fail(out.out(), 1, kill.in()) == !soon);
            CHECK(now() == (soon ? 3us : 5us));
            CHECK(!input_or_fail(in.in(), message, kill.in()));
        });
        simulation.process("inputs", [&] {
            wait_until(5us);
            if (!soon)
                CHECK(out.in().input() == 1);
        });
        simulation.process("kills", [&] {
            wait_until(soon ? 3us : 6us);
            kill.out().output(1);
            if (soon)
                kill.out().output(2);
            told_in_vain = false;
        });
        CHECK(simulation.run().ending == Ending::completed);
        CHECK(!told_in_vain);
    }
}

TEST_CASE("an alternation that an output woke sleeps again if the message has been given up") {
    Simulation simulation;
    auto& t800 = simulation.add<hardware::Processor>("t800");
    Channel<int> c("c");
    std::size_t chosen = 9;
    simulation.process(
        "alternates", [&] { chosen = alt(on(c.in(), [](int) {}), after(Time{60us}, [] {})); }, &t800);
    simulation.process(
        "keeps it from going on", [&] { wait_until(18us), compute(Cycles{400}); }, &t800, Priority::high);
    simulation.process("outputs", [&] {
        wait_until(20us);
        CHECK(!output_or_fail(c.out(), 1, Time{30us}));
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(chosen == 1);
}

TEST_CASE("an attempt costs the communication, startp, tin and endp, a reset costs resetch, and each a library call") {
    for (int call : {0, 201}) {
        Simulation simulation;
        auto& t800 = simulation.add<hardware::Processor>("t800", 20'000'000, Cycles{call});
        Channel<int> c("c");
        Time began{}, ended{}, reset_at{};
        simulation.process(
            "outputs",
            [&] {
                c.out().output(1);
                began = now();
                CHECK(output_or_fail(c.out(), 2, Time{1ms}));
                ended = now();
                reset(c.out());
                reset_at = now();
            },
            &t800);
        simulation.process(
            "inputs", [&] { c.in().input(), c.in().input(); }, &t800);
        simulation.run();
        CHECK(reset_at - ended == (3 + call) * test::cycle);
        CHECK(ended - began >= (12 + 30 + 13 + 19 + call) * test::cycle);
    }
}

TEST_CASE("attempts are refused on channels that do not have a link of their own") {
    Simulation simulation;
    auto& link = simulation.add<hardware::Link>();
    auto& a = simulation.add<hardware::Router>(nullptr);
    auto& b = simulation.add<hardware::Router>(nullptr);
    auto& routed = simulation.add<hardware::RouterLink>(link, a, b);
    Channel<int> c("c", simulation.add<hardware::Route>(std::vector<hardware::Hop>{{routed, true}}));
    simulation.process("outputs", [&] { output_or_fail(c.out(), 1, Time{1ms}); });
    CHECK_THROWS_WITH_AS(simulation.run(),
                         "channel c travels in packets, which routers carry to their end: its messages cannot be given "
                         "up, and its ends cannot be reset",
                         std::logic_error);
}

TEST_CASE("an end can be reset only by its owner, and not while a process is in it") {
    Simulation simulation;
    Channel<int> c("c");
    simulation.process("outputs", [&] { c.out().output(1); });
    simulation.process("inputs", [&] { wait_for(1us), c.in().input(); });
    simulation.process("resets", [&] { reset(c.out()); });
    CHECK_THROWS_WITH_AS(
        simulation.run(),
        "process resets resets channel c, but this end belongs to process outputs: a channel has one outputting "
        "and one inputting process",
        std::logic_error);
}
