// Tests the rules by which two processes meet in a channel.

#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using test::cycle;

TEST_CASE("the process that arrives second continues, and the first goes to the back of the ready queue") {
    Simulation simulation;
    Channel<int> c("c");
    std::string order;
    simulation.process("inputs first", [&] { c.in().input(), order += "i"; });
    simulation.process("outputs second", [&] { c.out().output(1), order += "o"; });
    simulation.process("ready before", [&] { order += "r"; });
    simulation.run();
    CHECK(order == "ori");
}

TEST_CASE("an outputter that arrives first waits as an inputter does") {
    Simulation simulation;
    Channel<int> c("c");
    std::string order;
    simulation.process("outputs first", [&] { c.out().output(1), order += "o"; });
    simulation.process("inputs second", [&] { c.in().input(), order += "i"; });
    simulation.process("ready before", [&] { order += "r"; });
    simulation.run();
    CHECK(order == "iro");
}

TEST_CASE("neither end continues before the other has come") {
    Simulation simulation;
    Channel<int> c("c");
    Time output_ended{}, input_ended{};
    simulation.process("outputter", [&] { c.out().output(1), output_ended = now(), c.out().output(2); });
    simulation.process("inputter", [&] {
        wait_for(std::chrono::microseconds{5});
        c.in().input();
        wait_for(std::chrono::microseconds{2});
        c.in().input(), input_ended = now();
    });
    simulation.run();
    CHECK(output_ended == std::chrono::microseconds{5});
    CHECK(input_ended == std::chrono::microseconds{7});
}

TEST_CASE("messages arrive once and in order, whichever end is late") {
    for (std::uint64_t seed : test::seeds(20)) {
        INFO(test::replay(seed));
        Simulation simulation;
        Channel<int> c("c");
        std::vector<int> received;
        auto dawdle = [](RandomStream& random) { wait_for(std::chrono::nanoseconds{random.below(3)}); };
        simulation.process("outputter", [&] {
            RandomStream random(seed, "outputter");
            for (int i = 0; i < 100; ++i)
                dawdle(random), c.out().output(i);
        });
        simulation.process("inputter", [&] {
            RandomStream random(seed, "inputter");
            for (int i = 0; i < 100; ++i)
                dawdle(random), received.push_back(c.in().input());
        });
        REQUIRE(simulation.run().ending == Ending::completed);
        REQUIRE(received.size() == 100);
        for (int i = 0; i < 100; ++i)
            REQUIRE(received[static_cast<std::size_t>(i)] == i);
    }
}

struct Owned {
    std::unique_ptr<int> value;
    WireForm wire_form() const { return WireForm(4); }
};

TEST_CASE("a message is moved and never copied") {
    Simulation simulation;
    Channel<Owned> c("c");
    int received = 0;
    simulation.process("outputter", [&] { c.out().output(Owned{std::make_unique<int>(7)}); });
    simulation.process("inputter", [&] { received = *c.in().input().value; });
    simulation.run();
    CHECK(received == 7);
}

TEST_CASE("a second user of an end is refused by name, also while the first waits for its processor") {
    for (bool placed : {false, true}) {
        CAPTURE(placed);
        Simulation simulation;
        Processor* p = placed ? &simulation.add<Processor>("p") : nullptr;
        Processor* q = placed ? &simulation.add<Processor>("q") : nullptr;
        Channel<int> c("busy");
        simulation.process(
            "first", [&] { c.out().output(1); }, p);
        simulation.process(
            "second", [&] { c.out().output(2); }, q);
        std::string message;
        try {
            simulation.run();
        } catch (const std::logic_error& error) {
            message = error.what();
        }
        CHECK(message ==
              "process second outputs to channel busy, but this end belongs to process first: a channel has one "
              "outputting and one inputting process");
    }
}

TEST_CASE("the process that arrived first goes to the back of the queue after the copy, not before") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Channel<std::array<char, 4000>> c("c"); // 2000 cycles, 100 us
    std::string order;
    simulation.process(
        "inputter", [&] { c.in().input(), order += "i"; }, &t800);
    simulation.process(
        "outputter", [&] { c.out().output({}), order += "o"; }, &t800);
    simulation.process(
        "ready meanwhile", [&] { wait_until(std::chrono::microseconds{50}), order += "m"; }, &t800);
    simulation.run();
    CHECK(order == "omi");
}

TEST_CASE(
    "on a processor the second process pays 2 cycles for each word of the copy, and both pay 19 for the instruction") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Channel<std::array<char, 10>> c("c"); // three words
    Time first_done{}, second_done{};
    simulation.process(
        "outputter", [&] { c.out().output({}), first_done = now(); }, &t800);
    simulation.process(
        "inputter", [&] { c.in().input(), second_done = now(); }, &t800);
    simulation.run();
    CHECK(second_done == (19 + 19 + 2 * 3) * cycle);
    CHECK(first_done == second_done);
    CHECK(t800.time_busy() == second_done);
}
