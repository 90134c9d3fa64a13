// Tests the waiting times of processes, which reports use.

#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

TEST_CASE("a process waits only if all its components wait") {
    Simulation simulation;
    constexpr Cycles one_millisecond{20'000};
    Process& works = simulation.process(
        "works", [=] { par([=] { compute(one_millisecond); }); }, &simulation.add<Processor>("a"));
    Process& both = simulation.process(
        "both", [=] { par([=] { compute(one_millisecond); }, [] { wait_for(milliseconds{3}); }); },
        &simulation.add<Processor>("b"));
    Process& sleeps = simulation.process("sleeps", [] {
        par([] { par([] { wait_for(milliseconds{2}); }); }, [] { wait_for(milliseconds{5}); });
        wait_for(milliseconds{1});
    });
    simulation.run();
    CHECK(works.time_waited() == Time{0});
    CHECK(both.time_waited() == milliseconds{2} - 13 * test::cycle); // endp of the computing process
    CHECK(sleeps.time_waited() == milliseconds{6});
}

TEST_CASE("a wait that outlasts the run counts until the end, and a process that has ended waits no more") {
    for (bool limited : {false, true}) {
        Simulation simulation;
        Channel<int> c("c");
        Process& stuck = simulation.process("stuck", [&] { c.in().input(); });
        Process& stuck_inside = simulation.process("stuck inside", [] {
            wait_for(milliseconds{1});
            par([] {},
                [] {
                    Channel<int> d("d");
                    d.in().input();
                });
        });
        Process& ended = simulation.process("ended", [] { wait_for(milliseconds{3}); });
        simulation.process("lasts", [] { wait_until(milliseconds{10}); });
        RunResult result = simulation.run(limited ? milliseconds{8} : Time::max());
        CHECK(stuck.time_waited() == result.time);
        CHECK(stuck_inside.time_waited() == result.time);
        CHECK(ended.time_waited() == milliseconds{3});
    }
}

TEST_CASE("a process waits while its bytes travel over a link, not while its processor begins the communication") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<int> c("c", link.from_a_to_b());
    Process& sends = simulation.process(
        "sends",
        [&] {
            c.out().output(1);
            compute(Cycles{20'000});
            c.out().output(2);
        },
        &simulation.add<Processor>("a"));
    Process& receives = simulation.process(
        "receives", [&] { c.in().input(), c.in().input(); }, &simulation.add<Processor>("b"));
    simulation.run();
    // Four bytes take 560 ns each. For the sender, the last byte lasts until the end of its acknowledge, which begins
    // after 260 ns and takes 100 ns. For the receiver it lasts 550 ns (LinkTiming).
    constexpr Time sent = 3 * nanoseconds{560} + nanoseconds{360}, received = 3 * nanoseconds{560} + nanoseconds{550};
    CHECK(sends.time_waited() == 2 * sent);
    CHECK(receives.time_waited() == received + sent + milliseconds{1});
}
