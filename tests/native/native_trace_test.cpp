// Tests the trace of native runs on threads, and how the clocks of ranks become one. rank_run_test.cpp has its runs on
// ranks.

#include "native/native_trace.hpp"

#include "classics/kinds.hpp"
#include "native/native_run.hpp"
#include "native/rank_clock.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "tests/native/ring_of.hpp"
#include "tests/native/told_trace.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <string>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

/// Relays numbers in a ring, beside a component that talks to another one on a channel of every process's name.
Catalogue traced_kinds() {
    ProcessKind kind;
    kind.name = "traced";
    kind.ports = {description::input<int>("in", "numbers", "numbers"),
                  description::output<int>("out", "numbers", "numbers")};
    kind.body = [](ProcessEnvironment& environment) {
        Channel<int> inside("inside");
        par(
            [&] {
                for (int i = 0; i < 20; ++i) {
                    if (environment.index() > 0)
                        environment.input<int>("in").input();
                    environment.output<int>("out").output(i);
                    inside.out().output(i);
                    if (environment.index() == 0)
                        environment.input<int>("in").input();
                }
            },
            [&] {
                for (int i = 0; i < 20; ++i)
                    inside.in().input();
            });
    };
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_classical_kinds(catalogue);
    catalogue.add(std::move(kind));
    return catalogue;
}

Network traced_network() { return *read_netlist_text(test::ring_of(5, "traced"), traced_kinds(), {}).network; }

RunReport run_traced(std::size_t threads, NativeTrace& trace) {
    NativeSettings settings;
    settings.threads = threads;
    settings.trace = &trace;
    settings.make_catalogue = [] { return std::make_shared<const Catalogue>(traced_kinds()); };
    return run_natively(traced_network(), settings);
}

} // namespace

TEST_CASE("the trace of a native run has the messages of the simulated run, in a possible order of time") {
    test::SimulatedMessages simulated;
    const Catalogue kinds = traced_kinds();
    const Network network = traced_network();
    Machine machine(network, kinds, 1);
    machine.trace_to(simulated);
    machine.run();
    for (const std::size_t threads : {1U, 2U, 3U, 5U}) {
        NativeTrace trace;
        const RunReport report = run_traced(threads, trace);
        test::ToldTrace told;
        trace.replay(network, told);
        test::PassedMessages passed = told.passed();
        CHECK(passed.at("inside").size() == 100); // five processes have a channel of this name
        CHECK(simulated.passed.at("inside").size() == 100);
        simulated.passed["inside"] = passed["inside"];
        CHECK(passed == simulated.passed);
        told.check_causes(Time{});
        told.check_channels_are_synchronous();
        CHECK(told.is_computing.size() == threads);
        CHECK(told.end >= report.result.time);
        CHECK(told.end < report.result.time + Time(1us)); // two notices of one time are told 1 ns apart
        CHECK(trace.warning() == "");
        for (const auto& lane : told.lanes)
            CHECK_MESSAGE(lane.second.activity == Activity::ended, lane.first);
        for (const ProcessUse& process : report.processes)
            CHECK(told.lanes.at(process.name).place == process.processor);
    }
}

TEST_CASE("a trace with too many notices ends where they are too many, and says so") {
    NativeTrace trace(Time::max(), 400);
    run_traced(2, trace);
    test::ToldTrace told;
    trace.replay(traced_network(), told);
    CHECK(told.turns_told > 10);
    CHECK(told.turns_told + 2 * told.messages.size() <= 402);
    REQUIRE(told.end);
    CHECK(told.why.starts_with("the record of thread "));
    CHECK(told.why.ends_with(" is full"));
    CHECK(trace.warning() == "the timelines end at " + to_string(*told.end) + ", where " + told.why +
                                 " with 200 events: make a shorter run, or one with fewer messages\n");
}

TEST_CASE("nothing is recorded after the time at which the trace ends") {
    NativeTrace trace(Time{1});
    run_traced(2, trace);
    test::ToldTrace told;
    trace.replay(traced_network(), told);
    CHECK(told.messages.empty());
    CHECK(told.end > Time{1});
    CHECK(told.why.empty());
}

TEST_CASE("the threads of a native run stand in place of the nodes") {
    NativeTrace trace;
    const RunReport report = run_traced(3, trace);
    const Network places = with_places(traced_network(), report);
    REQUIRE(places.nodes.size() == 3);
    CHECK(places.nodes[2].name == "thread 2");
    CHECK(places.connections.empty());
    CHECK(places.processes[4].node == 1);
    CHECK(places.hash == traced_network().hash);
}

TEST_CASE("times of a rank are converted by the offset of its clock, which may drift") {
    using native::ComparedClock;
    using native::Reading;
    // Rank 1 is 5 s ahead, begins 3 us before rank 0, and gains 20 us in the 2 s between the comparisons.
    const native::CommonClock clock({{.at = 1s}, {.at = 1s, .ahead = 5s, .error = 40ns}},
                                    {{.at = 3s}, {.at = 3s, .ahead = 5s + 20us, .error = 90ns}}, {1s + 10us, 6s + 7us});
    CHECK(clock.convert(0, Time{0}) == Time(3us));
    CHECK(clock.convert(0, Time(1s)) == Time(1s + 3us));
    CHECK(clock.convert(1, Time(1s - 7us)) == Time(1s - 7us - 10us));
    CHECK(clock.convert(1, Time(2s - 7us)) == Time(2s - 7us - 20us));
    REQUIRE(clock.clocks().size() == 1);
    CHECK(clock.clocks()[0].name == "rank 1");
    CHECK(clock.clocks()[0].ahead == 5s);
    CHECK(clock.clocks()[0].error == Time(90ns));
    CHECK(clock.clocks()[0].drift == Time(20us));
}
