#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;

TEST_CASE("a message passes from one process to another") {
    Simulation simulation;
    Channel<int> c("c");
    int received = 0;
    simulation.process("sender", [&] { c.out().output(42); });
    simulation.process("receiver", [&] { received = c.in().input(); });
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::completed);
    CHECK(received == 42);
}

TEST_CASE("two processes that both output first are reported as a cycle") {
    Simulation simulation;
    Channel<int> there("there"), back("back");
    simulation.process("ping", {there.out(), back.in()}, [&] { there.out().output(1), back.in().input(); });
    simulation.process("pong", {back.out(), there.in()}, [&] { back.out().output(1), there.in().input(); });
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::stuck);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle == std::vector<std::string>{"ping", "pong"});
}

TEST_CASE("a message over a link takes its time on the wire") {
    Simulation simulation;
    Channel<int> c("c", simulation.add<Link>().from_a_to_b());
    simulation.process("sender", [&] { c.out().output(42); });
    Time at{};
    simulation.process("receiver", [&] { c.in().input(), at = now(); });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(at == 3 * std::chrono::nanoseconds{560} + std::chrono::nanoseconds{550});
}

TEST_CASE("devices of any class are destroyed after the processes, the last device first") {
    struct Recorder {
        Recorder(Kernel&, std::string& l, std::string n) : log(l), name(std::move(n)) {}
        ~Recorder() { log += name; }
        std::string& log;
        std::string name;
    };
    std::string log;
    {
        Simulation simulation;
        simulation.add<Recorder>(log, "a");
        auto in_body = std::make_shared<Recorder>(simulation.add<Recorder>(log, "b"));
        in_body->name = "process ";
        simulation.process("holds", [held = std::move(in_body)] {});
        simulation.run();
    }
    CHECK(log == "process ba");
}
