// Tests PAR and PRI PAR.

#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <malloc.h>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using test::cycle;

TEST_CASE("a PAR starts its components in order and ends when its last component ends") {
    Simulation simulation;
    std::string order;
    Time ended{};
    simulation.process("parent", [&] {
        par([&] { order += "a", wait_for(microseconds{3}); }, [&] { order += "b", wait_for(microseconds{7}); },
            [&] { order += "c"; });
        ended = now();
    });
    simulation.run();
    CHECK(order == "abc");
    CHECK(ended == microseconds{7});
}

TEST_CASE("components of a nested PAR are named by their path") {
    Simulation simulation;
    std::string path;
    simulation.process("cluster[1].master", [&] {
        par([] {},
            [&] { par_for(3, [&](std::size_t i) { path = i == 2 ? Kernel::current()->running().path() : path; }); });
    });
    simulation.run();
    CHECK(path == "cluster[1].master/1/2");
}

TEST_CASE("a PAR without components ends at once") {
    Simulation simulation;
    bool after = false;
    simulation.process("parent", [&] { par_for(0, [](std::size_t) {}), after = true; });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(after);
}

TEST_CASE("in PRI PAR the high component computes first, and the low one while it waits") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Time high_done{}, low_done{}, high_again{};
    simulation.process(
        "parent",
        [&] {
            Time start = now();
            pri_par(
                [&] {
                    compute(Cycles{2000}), high_done = now() - start; // 100 us
                    wait_for(microseconds{50});
                    compute(Cycles{200}), high_again = now() - start;
                },
                [&] { compute(Cycles{2000}), low_done = now() - start; });
        },
        &t800);
    simulation.run();
    Time start_up = (10 + 19) * cycle; // runp starts the high process, which interrupts its parent, now the low process
    CHECK(high_done == start_up + microseconds{100});
    CHECK(high_again == start_up + microseconds{160} + 19 * cycle);      // it interrupts the low process
    CHECK(low_done == start_up + microseconds{210} + (19 + 13) * cycle); // the low process has ended with endp
}

TEST_CASE(
    "on a processor a PAR starts all but the last component, runs the last first, and each pays for its own end") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    std::string order;
    std::vector<Time> began, ended;
    auto component = [&](char name) {
        return [&, name] { order += name, began.push_back(now()), compute(Cycles{100}); };
    };
    simulation.process(
        "parent", [&] { par(component('a'), component('b'), component('c')), ended.push_back(now()); }, &t800);
    simulation.process(
        "other", [&] { order += "o", began.push_back(now()); }, &t800);
    simulation.run();
    CHECK(order == "coab"); // the other process was ready before a and b
    CHECK(began == std::vector<Time>{24 * cycle, 137 * cycle, 137 * cycle, 250 * cycle});
    CHECK(ended == std::vector<Time>{363 * cycle});
}

TEST_CASE("a PAR of one component on a processor costs only the end of the component") {
    Simulation simulation;
    simulation.process(
        "parent", [&] { par([] {}); }, &simulation.add<Processor>("t800"));
    CHECK(simulation.run().time == 13 * cycle);
}

TEST_CASE("the last component of a PAR continues as its parent, before other ready processes") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    std::string order;
    simulation.process(
        "parent",
        [&] {
            par([&] {
                simulation.process(
                    "other", [&] { order += "o"; }, &t800);
            });
            order += "p";
        },
        &t800);
    simulation.run();
    CHECK(order == "po");
}

TEST_CASE("ten thousand processes exist at once") {
    Simulation simulation;
    std::size_t ran = 0;
    simulation.process("parent",
                       [&] { par_for(10'000, [&](std::size_t i) { wait_for(std::chrono::nanoseconds{i}), ++ran; }); });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(ran == 10'000);
}

TEST_CASE("a hundred thousand PARs in a loop take no more memory than one") {
    Simulation simulation;
    std::size_t before = 0, after = 0;
    simulation.process("parent", [&] {
        for (int i = 0; i < 100'000; ++i) {
            par([] {}, [] {});
            if (i == 100)
                before = mallinfo2().uordblks + mallinfo2().hblkhd;
        }
        after = mallinfo2().uordblks + mallinfo2().hblkhd;
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(after <= before + 1000);
}
