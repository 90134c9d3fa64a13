// Tests that processes which continue after the end of the work do not change the work's figures.

#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "runtime/trace.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <string>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::milliseconds;

namespace {

/// Runs a process that works for 3 ms, and another that works for 5 ms. The second may then continue for 7 ms.
RunResult run(bool goes_on, Time limit = Time::max()) {
    Simulation simulation;
    Time gone_on{};
    simulation.process("works", [&] {
        wait_until(milliseconds{3});
        if (goes_on) {
            wait_until_work_is_over();
            gone_on = now();
            wait_for(milliseconds{7});
        }
    });
    simulation.process("works longer", [] { wait_until(milliseconds{5}); });
    RunResult result = simulation.run(limit);
    CHECK(gone_on == (goes_on && limit > milliseconds{5} ? milliseconds{5} : Time{0}));
    return result;
}

} // namespace

TEST_CASE("the run's time is the time of the work") {
    for (bool goes_on : {false, true}) {
        RunResult result = run(goes_on);
        CHECK(result.ending == Ending::completed);
        CHECK(result.time == milliseconds{5});
    }
}

TEST_CASE("the time limit applies only to the work, not to processes that continue after it") {
    CHECK(run(true, milliseconds{6}).ending == Ending::completed);
    RunResult result = run(true, milliseconds{4});
    CHECK(result.ending == Ending::time_limit);
    CHECK(result.time == milliseconds{4});
}

TEST_CASE("the work and the waits of processes are known at the end of the work") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    constexpr Cycles one_millisecond{20'000};
    Channel<int> never("never");
    Process& computes = simulation.process(
        "computes",
        [&] {
            compute(one_millisecond);
            wait_until_work_is_over();
            compute(one_millisecond);
        },
        &t800);
    Process& waits = simulation.process("waits", [&] { never.in().input(); });
    Time busy{}, waited{};
    std::optional<Time> computed_until;
    auto result = simulation.run(Time::max(), [&] {
        busy = t800.time_busy();
        waited = waits.time_waited();
        computed_until = computes.waits_since();
    });
    CHECK(result.ending == Ending::stuck);
    CHECK(result.time == milliseconds{1});
    CHECK(busy == milliseconds{1});
    CHECK(waited == milliseconds{1});
    CHECK(computed_until == milliseconds{1});
}

TEST_CASE("several processes continue after the work, and may wait for the end again") {
    Simulation simulation;
    Channel<int> c("c");
    int received = 0;
    simulation.process("outputs", [&] {
        wait_until_work_is_over();
        c.out().output(1);
        wait_until_work_is_over();
        c.out().output(2);
    });
    simulation.process("inputs", [&] {
        wait_until_work_is_over();
        for (int i = 0; i < 2; ++i)
            received += c.in().input();
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(received == 3);
}

TEST_CASE("only the work is traced") {
    struct Sink final : TraceSink {
        int told = 0, told_after_work = 0;
        std::optional<Time> work_over;
        void note() { ++(work_over ? told_after_work : told); }
        void turns(const Process&, Activity, Time) override { note(); }
        void communicated(const AnyChannel&, Time) override { note(); }
        void takes(const PlaceTaken&, Time) override { note(); }
        void leaves(const PlaceLeft&, Time) override { note(); }
        void over(Time now) override { work_over = now; }
    } sink;
    Simulation simulation;
    simulation.process("process", [] {
        wait_for(milliseconds{1});
        wait_until_work_is_over();
        wait_for(milliseconds{1});
    });
    simulation.process("another", [] { wait_for(milliseconds{2}); });
    simulation.trace_to(sink);
    simulation.run();
    CHECK(sink.work_over == milliseconds{2});
    CHECK(sink.told > 0);
    CHECK(sink.told_after_work == 0);
}
