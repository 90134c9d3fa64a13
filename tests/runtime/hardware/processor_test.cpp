// Tests how a processor divides its time, in cases computed by hand. For random cases see processor_model_test.cpp.

#include "runtime/channel.hpp"
#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::nanoseconds;
using test::cycle;

namespace {

constexpr Cycles one_slice{20'480};

} // namespace

TEST_CASE("cycles have their length at 20, 25 and 17.5 MHz") {
    for (auto [hertz, picoseconds] :
         {std::pair{20'000'000, 50'000'000}, {25'000'000, 40'000'000}, {17'500'000, 57'142'857}}) {
        Simulation simulation;
        Processor& processor = simulation.add<Processor>("p", hertz);
        simulation.process(
            "computes", [] { compute(Cycles{1000}); }, &processor);
        RunResult result = simulation.run();
        CHECK(result.time == Time{picoseconds});
        CHECK(processor.time_busy() == Time{picoseconds});
    }
}

TEST_CASE("a process that is not placed computes in no time") {
    Simulation simulation;
    simulation.process("computes", [] { compute(Cycles{1'000'000}); });
    CHECK(simulation.run().time == Time{0});
}

TEST_CASE("processors compute in parallel, and processes of one processor one after another") {
    Simulation simulation;
    Processor& p = simulation.add<Processor>("p");
    Processor& q = simulation.add<Processor>("q");
    std::vector<Time> done(3);
    simulation.process(
        "p0", [&] { compute(Cycles{100}), done[0] = now(); }, &p);
    simulation.process(
        "p1", [&] { compute(Cycles{100}), done[1] = now(); }, &p);
    simulation.process(
        "q0", [&] { compute(Cycles{150}), done[2] = now(); }, &q);
    simulation.run();
    CHECK(done == std::vector<Time>{100 * cycle, 200 * cycle, 150 * cycle});
}

TEST_CASE("a high-priority process interrupts a low one for 19 cycles, and the low one continues before its rivals") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Time high{}, interrupted{}, rival{};
    simulation.process(
        "interrupted", [&] { compute(Cycles{1000}), interrupted = now(); }, &t800);
    simulation.process(
        "rival", [&] { compute(Cycles{1000}), rival = now(); }, &t800);
    simulation.process(
        "high", [&] { wait_until(500 * cycle), compute(Cycles{100}), high = now(); }, &t800, Priority::high);
    simulation.run();
    // The process "high" is created last, so "interrupted" computes when "high" gets its first turn. This is one more
    // interrupt, before the delay of "high".
    CHECK(high == (500 + 19 + 100) * cycle);
    CHECK(interrupted == (1000 + 19 + 19 + 100) * cycle);
    CHECK(rival == (2000 + 19 + 19 + 100) * cycle);
}

TEST_CASE(
    "an interrupt waits for the end of an instruction: at most 58 cycles with divisions, 78 with floating point") {
    for (auto [instruction, at_most] : {std::pair{1, 19}, {39, 58}, {59, 78}}) {
        std::int64_t least = 1000, most = 0;
        for (std::int64_t moment = 10'000; moment < 10'059; ++moment) {
            Simulation simulation;
            Processor& t800 = simulation.add<Processor>("t800");
            Time began{}, ended{};
            simulation.process(
                "high", [&, moment] { wait_until(moment * cycle), began = now(); }, &t800, Priority::high);
            simulation.process(
                "low",
                [&, instruction = instruction] {
                    compute(Cycles{59 * 39 * 10}, {.instruction = Cycles{instruction}}), ended = now();
                },
                &t800);
            simulation.run();
            std::int64_t latency = began / cycle - moment;
            least = std::min(least, latency), most = std::max(most, latency);
            CHECK(ended == (59 * 39 * 10 + 19) * cycle); // only the switches are lost
        }
        CHECK(least == 19);
        CHECK(most == at_most - (instruction > 1)); // in whole cycles; the instruction's first cycle has passed
    }
}

TEST_CASE("a high-priority process is not interrupted by another, and not timesliced") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Time first{}, second{};
    simulation.process(
        "first", [&] { compute(5 * one_slice), first = now(); }, &t800, Priority::high);
    simulation.process(
        "second", [&] { wait_until(10 * cycle), compute(Cycles{10}), second = now(); }, &t800, Priority::high);
    simulation.process(
        "low", [] { compute(Cycles{10}); }, &t800);
    simulation.run();
    CHECK(first == 5 * Processor::timeslice);
    CHECK(second == first + (4 + 10) * cycle); // the time has passed by then, and the instruction takes 4 cycles
}

TEST_CASE("a low-priority process with rivals loses the processor after one to two timeslice periods") {
    for (std::int64_t start = 1; start < 20'480; start += 1024) {
        CAPTURE(start);
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        Time rival_began{};
        simulation.process(
            "long", [&] { wait_until(start * cycle), compute(10 * one_slice); }, &t800);
        simulation.process(
            "rival",
            [&] {
                wait_until(start * cycle + nanoseconds{1});
                rival_began = now(); // only the process on the processor executes
            },
            &t800);
        simulation.run();
        Time ran = rival_began - start * cycle;
        CHECK(ran >= Processor::timeslice);
        CHECK(ran <= 2 * Processor::timeslice);
        CHECK(rival_began % Processor::timeslice == cycle);
    }
}

TEST_CASE("a process gives way at a jump or loop shortly after the end of a period, and its rivals run for two") {
    for (auto [between, late] : {std::pair{1, 1}, {500, 20}, {1000, 520}, {100'000, 2520}}) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        std::vector<Time> began;
        simulation.process(
            "in long loops", [between = between] { compute(Cycles{123'000}, {.between_points = Cycles{between}}); },
            &t800);
        for (int i : {1, 2})
            simulation.process(
                fmt::format("rival {}", i), [&] { began.push_back(now()), compute(5 * one_slice); }, &t800);
        simulation.run();
        REQUIRE(began.size() == 2);
        CHECK(began[0] == Processor::timeslice + late * cycle);
        // At the end of its second period, the second rival has run for a whole period.
        CHECK(began[1] == (began[0] / Processor::timeslice + 2) * Processor::timeslice + cycle);
    }
}

TEST_CASE("with n low-priority processes none waits longer than 2n - 2 timeslice periods") {
    for (int n = 2; n <= 6; ++n) {
        CAPTURE(n);
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        Time longest{};
        for (int i = 1; i < n; ++i)
            simulation.process(
                "greedy", [] { compute(40 * one_slice); }, &t800);
        simulation.process(
            "polite",
            [&] {
                for (int i = 0; i < 10; ++i) {
                    wait_for(microseconds{10 + 137 * i});
                    Time since = now();
                    wait_for(microseconds{1});
                    longest = std::max(longest, now() - since - microseconds{1});
                }
            },
            &t800);
        simulation.run();
        CHECK(longest <= (2 * n - 2) * Processor::timeslice);
        CHECK(longest > (2 * n - 2) * Processor::timeslice - microseconds{150});
    }
}

TEST_CASE("impossible clocks, computations and processors are refused") {
    Simulation simulation;
    CHECK_THROWS_AS(simulation.add<Processor>("stopped", 0), std::logic_error);
    Processor& t800 = simulation.add<Processor>("t800");
    simulation.process(
        "endless",
        [] {
            CHECK_THROWS_AS(compute(Cycles{1}, {.between_points = Cycles{0}}), std::logic_error);
            CHECK_THROWS_AS(compute(Cycles{1}, {.instruction = Cycles{0}}), std::logic_error);
        },
        &t800);
    simulation.process(
        "backwards", [] { compute(Cycles{-1}); }, &t800);
    CHECK_THROWS_WITH_AS(simulation.run(), "process backwards computes for a negative number of cycles",
                         std::logic_error);
}

TEST_CASE("the cost of a library call is also paid for soft channels") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800", 20'000'000, instructions::toolset_channel_call);
    Channel<int> c("c");
    simulation.process(
        "a", [&] { c.out().output(1); }, &t800);
    simulation.process(
        "b", [&] { c.in().input(); }, &t800);
    CHECK(simulation.run().time == (201 + 23 + 201 + 19 + 2) * cycle); // and 2 for the copy of a word
}

TEST_CASE("a process switch has the stated cost, except if a process takes another's place or continues") {
    auto time = [](Cycles switching) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800", Processor::usual_clock, Cycles{0}, Memory{}, switching);
        simulation.process(
            "a", [] { compute(Cycles{1000}); }, &t800);
        simulation.process(
            "b", [] { compute(Cycles{1000}); }, &t800);
        return simulation.run().time;
    };
    CHECK(time(Cycles{0}) == 2000 * cycle);
    CHECK(time(Cycles{4}) == (2000 + 2 * 4) * cycle);
    CHECK_THROWS_AS(time(Cycles{-1}), std::logic_error);
}

TEST_CASE("a process that continues after an interrupt pays for no switch, and the interrupting one pays 19 cycles") {
    auto time = [](Cycles switching) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800", Processor::usual_clock, Cycles{0}, Memory{}, switching);
        simulation.process(
            "high", [] { wait_until(500 * cycle), compute(Cycles{100}); }, &t800, Priority::high);
        simulation.process(
            "low", [] { compute(Cycles{1000}); }, &t800);
        return simulation.run().time;
    };
    CHECK(time(Cycles{4}) - time(Cycles{0}) == 2 * 4 * cycle); // one for each process when it begins
}

TEST_CASE("messages of one word and of ten words on one processor cost the cycles of their instructions") {
    auto busy = [](auto message) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        Channel<decltype(message)> c("c");
        simulation.process(
            "inputs", [&] { c.in().input(); }, &t800);
        simulation.process(
            "outputs", [&] { c.out().output(message); }, &t800);
        simulation.run();
        return t800.time_busy();
    };
    CHECK(busy(std::int32_t{}) == (19 + 23) * cycle);
    CHECK(busy(std::array<std::int32_t, 10>{}) == (19 + 19 + 2 * 10) * cycle);
}
