// Tests the end of virtual time after 106 days. A later event ends the run with an error, and nothing overflows.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <string>

using namespace placedpar;
using namespace placedpar::hardware;

namespace {

constexpr Cycles very_many{std::numeric_limits<std::int64_t>::max()};

struct LongMessage {
    WireForm wire_form() const { return WireForm(1'000'000); }
};

std::string error_of(Simulation& simulation) {
    try {
        simulation.run();
    } catch (const std::overflow_error& error) {
        return error.what();
    }
    return "none";
}

} // namespace

TEST_CASE("a computation beyond the end of virtual time ends the run with an error that names its process") {
    Simulation simulation;
    Processor& slow = simulation.add<Processor>("slow", 1);
    int rounds = 0;
    simulation.process(
        "patient",
        [&] {
            for (; rounds < 1000; ++rounds)
                compute(Cycles{5'000'000});
        },
        &slow);
    CHECK(error_of(simulation) == "virtual time ends after 106 days, but process patient would take longer: "
                                  "shorten its computation or delay");
    CHECK(rounds == 1);
}

TEST_CASE("a delay beyond the end of virtual time ends the run after everything before it has happened") {
    Simulation simulation;
    Time last{};
    simulation.process("waits", [] { wait_for(Time::max() - Time{3}), wait_for(Time{3}); });
    simulation.process("earlier", [&] { wait_until(Time::max() - Time{1}), last = now(); });
    CHECK(error_of(simulation).find("process waits would take longer") != std::string::npos);
    CHECK(last == Time::max() - Time{1});
}

TEST_CASE("a message that a link would finish beyond the end of virtual time ends the run") {
    Simulation simulation;
    Channel<LongMessage> c("c");
    c.put_on(simulation.add<Link>(LinkTiming{.bits_per_second = 1, .wire_delay = std::chrono::microseconds{5}})
                 .from_a_to_b());
    simulation.process("sender", [&] { c.out().output({}); });
    simulation.process("receiver", [&] { c.in().input(); });
    CHECK(error_of(simulation).find("a message on a link would take longer") != std::string::npos);
}

TEST_CASE("processes of both priorities, timeslices, timers and links work just before the end of virtual time") {
    Simulation simulation;
    Processor& slow = simulation.add<Processor>("slow", 1);
    Processor& t800 = simulation.add<Processor>("t800");
    Channel<int> c("c"), d("d");
    Link& link = simulation.add<Link>();
    c.put_on(link.from_a_to_b()), d.put_on(link.from_b_to_a());
    static constexpr Time late = Time::max() - std::chrono::microseconds{1};
    simulation.process(
        "low", [] { compute(very_many); }, &slow);
    simulation.process(
        "low too", [] { wait_until(late), compute(very_many); }, &slow);
    simulation.process(
        "high", [] { wait_until(late), compute(very_many); }, &slow, Priority::high);
    for (const char* name : {"sliced", "sliced too"})
        simulation.process(
            name, [] { wait_until(late), compute(very_many), compute(very_many); }, &t800);
    simulation.process("sender", [&] { wait_until(late), c.out().output(1); });
    simulation.process("receiver", [&] { c.in().input(); });
    simulation.process("sends back", [&] { wait_until(late), d.out().output(1); });
    simulation.process("alternates", [&] { alt(on(d.in(), [](int) {}), after(Time::max(), [] {})); });
    simulation.process(
        "timer",
        [] { wait_until(late), Timer().wait_after(plus(Timer().read(), std::numeric_limits<std::int32_t>::max())); },
        &t800);
    CHECK(error_of(simulation).starts_with("virtual time ends after 106 days"));
}

TEST_CASE("a limit on the run ends it before the end of virtual time") {
    Simulation simulation;
    simulation.process("waits", [] { wait_for(Time::max()); });
    RunResult result = simulation.run(Time::max() - Time{1});
    CHECK(result.ending == Ending::time_limit);
    CHECK(result.time == Time::max() - Time{1});
}
