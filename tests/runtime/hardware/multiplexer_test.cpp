// Virtual channels over a link.

#include "runtime/hardware/link.hpp"
#include "runtime/hardware/multiplexer.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::nanoseconds;
using test::cycle;

namespace {

struct TwoNodes {
    Simulation simulation;
    Processor& a = simulation.add<Processor>("a");
    Processor& b = simulation.add<Processor>("b");
    Link& link = simulation.add<Link>();
    Multiplexer& multiplexer = simulation.add<Multiplexer>("m", link, &a, &b);
};

} // namespace

TEST_CASE("two channels each way over one link: every message arrives, in the order of its channel") {
    TwoNodes nodes;
    std::list<Channel<int>> channels;
    std::array<std::vector<int>, 4> received;
    for (std::size_t i = 0; i < 4; ++i) {
        bool forth = i < 2;
        Channel<int>& c = channels.emplace_back("c");
        c.put_on(nodes.multiplexer.add_channel(forth));
        nodes.simulation.process(
            "outputter",
            [&c, i] {
                for (int k = 0; k < 20; ++k)
                    c.out().output(static_cast<int>(100 * i) + k);
            },
            forth ? &nodes.a : &nodes.b);
        nodes.simulation.process(
            "inputter",
            [&c, &received, i] {
                for (int k = 0; k < 20; ++k)
                    received[i].push_back(c.in().input());
            },
            forth ? &nodes.b : &nodes.a);
    }
    CHECK(nodes.simulation.run().ending == Ending::completed);
    for (std::size_t i = 0; i < 4; ++i) {
        REQUIRE(received[i].size() == 20);
        for (int k = 0; k < 20; ++k)
            CHECK(received[i][static_cast<std::size_t>(k)] == static_cast<int>(100 * i) + k);
    }
}

TEST_CASE(
    "an outputter goes on only after its message was input, and a late inputter does not stop the other channel") {
    TwoNodes nodes;
    Channel<int> late("late"), prompt("prompt");
    late.put_on(nodes.multiplexer.add_channel(true));
    prompt.put_on(nodes.multiplexer.add_channel(true));
    Time late_output{}, late_input{}, prompt_output{};
    nodes.simulation.process(
        "outputs late", [&] { late.out().output(1), late_output = now(); }, &nodes.a);
    nodes.simulation.process(
        "outputs prompt", [&] { prompt.out().output(1), prompt_output = now(); }, &nodes.a);
    nodes.simulation.process(
        "inputs late", [&] { wait_until(microseconds{1000}), late.in().input(), late_input = now(); }, &nodes.b);
    nodes.simulation.process(
        "inputs prompt", [&] { prompt.in().input(); }, &nodes.b);
    CHECK(nodes.simulation.run().ending == Ending::completed);
    CHECK(late_input >= microseconds{1000});
    CHECK(late_output > late_input);
    CHECK(prompt_output < microseconds{200});
}

TEST_CASE("the stated price: a packet each way on the link, two handlings on each processor") {
    TwoNodes nodes;
    Channel<std::array<char, 100>> c("c");
    c.put_on(nodes.multiplexer.add_channel(true));
    Time output{}, input{};
    nodes.simulation.process(
        "outputs", [&] { c.out().output({}), output = now(); }, &nodes.a);
    nodes.simulation.process(
        "inputs", [&] { c.in().input(), input = now(); }, &nodes.b);
    CHECK(nodes.simulation.run().ending == Ending::completed);
    CHECK(nodes.link.from_a_to_b().bytes_carried() == Multiplexer::header_bytes + 100);
    CHECK(nodes.link.from_b_to_a().bytes_carried() == Multiplexer::header_bytes);
    // a: the sender handles the packet and outputs it, the receiver inputs the acknowledge and handles it, and
    // the program outputs: 200 + 19, 19 + 200 and 19 cycles, and the receiver asks for a second packet, 19.
    // The sender's start interrupts the program once at most.
    for (const Processor* processor : {&nodes.a, &nodes.b}) {
        Time least = (2 * 200 + 4 * 19) * cycle;
        CHECK(processor->time_busy() >= least);
        CHECK(processor->time_busy() <= least + 2 * 19 * cycle);
    }
    Time on_link = 103 * nanoseconds{560} + nanoseconds{550};
    // The inputting process has low priority: b has handled the acknowledge packet before it goes on.
    CHECK(input >= on_link + 3 * 200 * cycle);
    CHECK(input <= on_link + (3 * 200 + 6 * 19) * cycle);
    Time back_on_link = 3 * nanoseconds{560} + nanoseconds{550};
    CHECK(output - input >= back_on_link + 200 * cycle);
    CHECK(output - input <= back_on_link + (200 + 3 * 19) * cycle);
}

TEST_CASE("an end of a multiplexer that has nothing to do does not keep a run from completing") {
    TwoNodes nodes;
    Channel<int> c("c");
    c.put_on(nodes.multiplexer.add_channel(true));
    nodes.simulation.process(
        "computes", [] { compute(Cycles{10}); }, &nodes.a);
    CHECK(nodes.simulation.run().ending == Ending::completed);
}
