// Tests the report of a deadlock.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/switched_stack.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace placedpar;

namespace {

/// Runs Dijkstra's philosophers. Each takes the left fork, then the right fork.
Deadlock three_philosophers() {
    Simulation simulation;
    std::list<Channel<int>> take_left, take_right;
    std::vector<Input<int>> left, right;
    for (std::size_t i = 0; i < 3; ++i) {
        left.push_back(take_left.emplace_back("left[" + std::to_string(i) + "]").in());
        right.push_back(take_right.emplace_back("right[" + std::to_string(i) + "]").in());
    }
    auto of = [](std::list<Channel<int>>& channels, std::size_t i) {
        return std::next(channels.begin(), static_cast<long>(i));
    };
    for (std::size_t i = 0; i < 3; ++i) {
// clang-format off
#line 1 "philosophers.cpp"
        auto philosopher = [&, i] {
            of(take_left, i)->out().output(1);
            wait_for(std::chrono::nanoseconds{10});
            of(take_right, i)->out().output(1);
        };
        auto fork = [&, i] {
            alt(on(left[i], [&](int) { left[i].input(); }),
                on(right[(i + 2) % 3], [&](int) { right[(i + 2) % 3].input(); }));
        };
#line 44 "deadlock_test.cpp"
        // clang-format on
        simulation.process("philosopher[" + std::to_string(i) + "]", philosopher);
        simulation.process("fork[" + std::to_string(i) + "]", fork);
    }
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::stuck);
    REQUIRE(result.deadlock);
    return *result.deadlock;
}

} // namespace

TEST_CASE("three philosophers with a fork each give the stored report, word for word") {
    CHECK(
        three_philosophers().text() ==
        R"(wait cycle: philosopher[0] -> fork[1] -> philosopher[1] -> fork[2] -> philosopher[2] -> fork[0] -> philosopher[0]

process                      operation                  channel                                      program
philosopher[0]               outputs                    right[0]                                     philosophers.cpp:4
fork[0]                      inputs                     left[0]                                      philosophers.cpp:7
philosopher[1]               outputs                    right[1]                                     philosophers.cpp:4
fork[1]                      inputs                     left[1]                                      philosophers.cpp:7
philosopher[2]               outputs                    right[2]                                     philosophers.cpp:4
fork[2]                      inputs                     left[2]                                      philosophers.cpp:7

channel                                      outputter                    inputter                     waiting
right[0]                                     philosopher[0]               fork[1]                      outputter
left[0]                                      philosopher[0]               fork[0]                      inputter
right[1]                                     philosopher[1]               fork[2]                      outputter
left[1]                                      philosopher[1]               fork[1]                      inputter
right[2]                                     philosopher[2]               fork[0]                      outputter
left[2]                                      philosopher[2]               fork[2]                      inputter
)");
}

TEST_CASE("two reports of the same deadlock are equal") {
    CHECK(three_philosophers().text() == three_philosophers().text());
}

TEST_CASE("a partial deadlock lists the processes that are left and not those that ended") {
    Simulation simulation;
    Channel<int> c("c"), d("d");
    simulation.process("fine", [&] { wait_for(std::chrono::microseconds{3}); });
    simulation.process("once", [&] { c.out().output(1); });
    simulation.process("twice", [&] { c.in().input(), c.in().input(); });
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::stuck);
    CHECK(result.time == std::chrono::microseconds{3});
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle.empty());
    REQUIRE(result.deadlock->processes.size() == 1);
    CHECK(result.deadlock->processes[0].path == "twice");
    CHECK(result.deadlock->processes[0].activity == Activity::inputting);
    REQUIRE(result.deadlock->channels.size() == 1);
    CHECK(result.deadlock->channels[0].outputter == "once (has ended)");
    CHECK(result.deadlock->text().starts_with("no wait cycle: twice inputs for ever, but once has ended; "));
    CHECK(result.deadlock->channels[0].waiting == "inputter");
}

TEST_CASE("the cycle is found through the PARs of its processes") {
    Simulation simulation;
    Channel<int> there("there"), back("back");
    auto exchange = [](Channel<int>& mine, Channel<int>& other) {
        par([] {}, [&] { mine.out().output(1); });
        other.in().input();
    };
    simulation.process("left", {there.out(), back.in()}, [&] { exchange(there, back); });
    simulation.process("right", {back.out(), there.in()}, [&] { exchange(back, there); });
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle == std::vector<std::string>{"left", "left/1", "right", "right/1"});
}

TEST_CASE("a component that has ended is reported as the process whose PAR it was in") {
    Simulation simulation;
    Channel<int> c("c");
    simulation.process("server", [&] {
        par([&] { c.in().input(); });
        Channel<int> never("never");
        never.in().input();
    });
    simulation.process("client", [&] { c.out().output(1), c.out().output(2); });
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    REQUIRE(result.deadlock->channels.size() == 2);
    CHECK(result.deadlock->channels[0].outputter == "none yet");
    CHECK(result.deadlock->channels[1].name == "c");
    CHECK(result.deadlock->channels[1].inputter == "server");
}

TEST_CASE("a component at the address of an earlier one is not mistaken for it, so no false cycle is reported") {
    Simulation simulation;
    Channel<int> a("a"), b("b");
    const Process* first = nullptr;
    bool same_place = false;
    simulation.process("x", [&] {
        par([&] { a.in().input(); },
            [&] {
                first = &Kernel::current()->running();
                a.out().output(1);
            });
        par([&] {
            same_place = &Kernel::current()->running() == first;
            a.in().input();
        });
    });
    simulation.process("y", [&] { b.in().input(); });
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    if (!SwitchedStack::is_watched()) // AddressSanitizer does not reuse freed memory at once
        REQUIRE(same_place);
    // Process x/0 waits for an outputter of a. This is x, because x's last component output to a. x waits for x/0.
    CHECK(result.deadlock->cycle == std::vector<std::string>{"x", "x/0"});
    REQUIRE(result.deadlock->channels.size() == 2);
    CHECK(result.deadlock->channels[0].outputter == "none yet");
    CHECK(result.deadlock->channels[1].name == "a");
    CHECK(result.deadlock->channels[1].outputter == "x");
}

TEST_CASE("a component that has not ended is named itself as a partner, also in the cycle") {
    Simulation simulation;
    Channel<int> request("request"), reply("reply");
    simulation.process(
        "server", [&] { par([] {}, [&] { request.in().input(), reply.out().output(1), reply.out().output(2); }); });
    simulation.process("client", [&] { request.out().output(1), reply.in().input(), request.out().output(2); });
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle == std::vector<std::string>{"server/1", "client"});
    CHECK(result.deadlock->channels[0].inputter == "server/1");
    CHECK(result.deadlock->channels[1].name == "reply");
    CHECK(result.deadlock->channels[1].outputter == "server/1");
}

TEST_CASE("a ring of ten thousand processes that all output first is reported in order") {
    constexpr std::size_t n = 10'000;
    Simulation simulation;
    std::vector<std::unique_ptr<Channel<int>>> ring;
    for (std::size_t i = 0; i < n; ++i)
        ring.push_back(std::make_unique<Channel<int>>("ring[" + std::to_string(i) + "]"));
    for (std::size_t i = 0; i < n; ++i) {
        auto next = ring[i]->out();
        auto previous = ring[(i + n - 1) % n]->in();
        simulation.process("member[" + std::to_string(i) + "]", {next, previous},
                           [=] { next.output(1), previous.input(); });
    }
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    REQUIRE(result.deadlock->cycle.size() == n);
    CHECK(result.deadlock->cycle[1] == "member[1]");
    CHECK(result.deadlock->processes.size() == n);
}

TEST_CASE("a PAR of any form states its place in the program") {
    Simulation simulation;
    Channel<int> c("c");
    auto never = [&] { c.in().input(); };
// clang-format off
#line 1 "pars.cpp"
    simulation.process("par", [&] { par(never, [] {}); });
    simulation.process("par_for", [] { par_for(1, [](std::size_t) { Channel<int> d("d"); d.in().input(); }); });
    simulation.process("pri_par", [] { pri_par([] {}, [] { Channel<int> e("e"); e.in().input(); }); });
#line 206 "deadlock_test.cpp"
    // clang-format on
    RunResult result = simulation.run();
    REQUIRE(result.deadlock);
    std::vector<std::string> joining;
    for (const StuckProcess& process : result.deadlock->processes)
        if (process.activity == Activity::joining)
            joining.push_back(process.path + " " + process.where);
    CHECK(joining == std::vector<std::string>{"par pars.cpp:1", "par_for pars.cpp:2", "pri_par pars.cpp:3"});
}

namespace {

/// Runs two processes that wait for each other, one that never ends, and `others`. Stops the run after a while.
RunResult partly_stuck(const std::function<void(Simulation&)>& others) {
    Simulation simulation;
    Channel<int> a("a"), b("b"), tick("tick");
    simulation.process("left", [&] {
        a.out().output(1);
        b.in().input();
        a.out().output(2);
    });
    simulation.process("right", [&] {
        a.in().input();
        b.out().output(1);
        b.out().output(2);
    });
    simulation.process("clock", [&] {
        for (;;) {
            wait_for(std::chrono::microseconds{1});
            tick.out().output(1);
        }
    });
    simulation.process("counter", [&] {
        for (;;)
            tick.in().input();
    });
    others(simulation);
    return simulation.run(std::chrono::microseconds{100});
}

std::vector<std::string> paths(const Deadlock& deadlock) {
    std::vector<std::string> result;
    for (const StuckProcess& each : deadlock.processes)
        result.push_back(each.path);
    return result;
}

} // namespace

TEST_CASE("a partial deadlock is reported when the run is stopped") {
    RunResult result = partly_stuck([](Simulation&) {});
    CHECK(result.ending == Ending::time_limit);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle == std::vector<std::string>{"left", "right"});
    CHECK(paths(*result.deadlock) == std::vector<std::string>{"left", "right"});
}

TEST_CASE("a process that waits for a deadlocked process is in the deadlock, and a process with a timeout is not") {
    Channel<int> more("more"), perhaps("perhaps");
    RunResult result = partly_stuck([&](Simulation& simulation) {
        simulation.process("starved", [&] { more.in().input(), more.in().input(); });
        simulation.process("ends", [&] { more.out().output(1), perhaps.out().output(1); });
        simulation.process("patient", [&] {
            perhaps.in().input();
            alt(on(perhaps.in(), [](int) {}), after(std::chrono::seconds{1}, [] {}));
        });
    });
    REQUIRE(result.deadlock);
    CHECK(paths(*result.deadlock) == std::vector<std::string>{"left", "right", "starved"});
}

TEST_CASE("a process that can continue is not reported as deadlocked when the run is stopped") {
    // A ring of processes over links is stopped at every microsecond. Some process always waits, but never for ever.
    for (int stop = 1; stop < 60; ++stop) {
        Simulation simulation;
        std::list<Channel<std::array<char, 4>>> ring;
        for (int i = 0; i < 3; ++i)
            ring.emplace_back("c").put_on(simulation.add<hardware::Link>().from_a_to_b());
        auto at = [&](int i) { return std::next(ring.begin(), i % 3); };
        for (int i = 0; i < 3; ++i)
            simulation.process("p", [=] {
                for (bool first = i == 0;; first = false) {
                    if (!first)
                        at(i)->in().input();
                    at(i + 1)->out().output({});
                }
            });
        CHECK(!simulation.run(std::chrono::microseconds{stop}).deadlock);
    }
}

TEST_CASE("STOP stops one process while others continue, and the report names all that wait for it for ever") {
    Simulation simulation;
    auto& t800 = simulation.add<hardware::Processor>("t800");
    Channel<int> c("c");
    Time others{};
    simulation.process(
        "p", {c.out()}, [&] { par([&] { c.out().output(1); }, [] { stop(); }); }, &t800);
    simulation.process(
        "q", {c.in()}, [&] { c.in().input(), c.in().input(); }, &t800);
    simulation.process(
        "other", [&] { compute(Cycles{20'000}), others = now(); }, &t800);
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::stuck);
    CHECK(others >= std::chrono::milliseconds{1});
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle.empty());
    const auto& left = result.deadlock->processes;
    REQUIRE(left.size() == 3);
    CHECK(left[0].path == "p");
    CHECK(left[0].activity == Activity::joining);
    CHECK(left[1].path == "q");
    CHECK(left[2].path == "p/1");
    CHECK(left[2].activity == Activity::stopped);
    CHECK(left[2].where.starts_with("deadlock_test.cpp:"));
    CHECK(result.deadlock->text().find("p/1                          has stopped") != std::string::npos);
}

TEST_CASE("at a time limit the report names a stopped process and those that wait for it, and no others") {
    Simulation simulation;
    auto& t800 = simulation.add<hardware::Processor>("t800");
    Channel<int> c("c"), d("d");
    simulation.process("stops", {c.out()}, [] { stop(); });
    simulation.process("waits", {c.in()}, [&] { c.in().input(); });
    simulation.process("patient", {d.in()}, [&] { d.in().input(); });
    simulation.process(
        "busy", {d.out()},
        [&] {
            for (;;)
                compute(Cycles{100});
        },
        &t800);
    RunResult result = simulation.run(std::chrono::milliseconds{1});
    CHECK(result.ending == Ending::time_limit);
    REQUIRE(result.deadlock);
    REQUIRE(result.deadlock->processes.size() == 2);
    CHECK(result.deadlock->processes[0].path == "stops");
    CHECK(result.deadlock->processes[1].path == "waits");
}

TEST_CASE("processes that never ran are named at the end of a run") {
    Simulation simulation;
    auto& t800 = simulation.add<hardware::Processor>("t800");
    SUBCASE("a process of high priority never let go of the processor") {
        auto forever = [] {
            for (;;)
                compute(Cycles{1000});
        };
        simulation.process("high", forever, &t800, Priority::high);
        simulation.process(
            "low", [] {}, &t800);
        simulation.process("elsewhere", [] { par([] { wait_for(std::chrono::seconds{1}); }, [] {}); });
        RunResult result = simulation.run(std::chrono::milliseconds{1});
        CHECK(result.never_ran == std::vector<std::string>{"low"});
        CHECK(!result.deadlock);
    }
    SUBCASE("the processor was halted from the beginning") {
        t800.halt_at(Time{0});
        simulation.process(
            "first", [] {}, &t800);
        simulation.process(
            "second", [] {}, &t800);
        CHECK(simulation.run().never_ran == std::vector<std::string>{"first", "second"});
    }
    SUBCASE("all have had a turn") {
        Channel<int> never("never");
        simulation.process(
            "waits", [&] { never.in().input(); }, &t800);
        CHECK(simulation.run().never_ran.empty());
    }
}
