// Tests the load of routers on their processors: their priority, and the cost of a packet.

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"
#include "tests/runtime/hardware/routed_machine.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;
using hardware::Processor;
using std::chrono::microseconds;
using test::cycle;
using test::line;
using test::RoutedMachine;

namespace {

/// The arrival time of a message that is routed over a computing processor, and the end of this processor's computation
/// of 10 ms.
struct BesideAComputation {
    Time message{}, computation{};
};

BesideAComputation send_beside_a_computation(const hardware::RouterCosts& costs) {
    RoutedMachine machine(line(3), costs);
    Channel<int> c("c", machine.route({0, 1, 2}));
    BesideAComputation at;
    machine.simulation.process(
        "outputs", [&] { wait_until(microseconds{100}), c.out().output(1); }, machine.processors[0]);
    machine.simulation.process(
        "computes", [&] { compute(Cycles{200'000}), at.computation = now(); }, machine.processors[1]);
    machine.simulation.process(
        "inputs", [&] { c.in().input(), at.message = now(); }, machine.processors[2]);
    CHECK(machine.simulation.run().ending == Ending::completed);
    return at;
}

} // namespace

TEST_CASE("low-priority routers wait for their turn beside a computation and do not interrupt it") {
    BesideAComputation high = send_beside_a_computation({}),
                       low = send_beside_a_computation({.priority = Priority::low});
    constexpr Time slice = Processor::timeslice;
    CHECK(high.message < microseconds{200});
    // The packet arrives in the first period, and its receiver gets its turn after the second period. The sender then
    // waits for two more periods of the computation.
    CHECK(low.message > 4 * slice);
    CHECK(low.message < 4 * slice + microseconds{50});
    constexpr Time first_inputs = 2 * 19 * cycle;          // the receivers' inputs at the two links
    constexpr Time passed_on = 2 * 2 * (200 + 19) * cycle; // a packet and its acknowledge
    constexpr Time interrupts = 2 * 2 * 19 * cycle;
    CHECK(high.computation == 200'000 * cycle + first_inputs + passed_on + interrupts);
    CHECK(low.computation == 200'000 * cycle + first_inputs + passed_on);
}

TEST_CASE("a packet costs its router's handling at every processor on its way") {
    BesideAComputation usual = send_beside_a_computation({}),
                       slow = send_beside_a_computation({.handling = Cycles{1200}}),
                       free = send_beside_a_computation({.handling = Cycles{0}});
    // The packet is sent, passed on and received before the inputting process continues, and its acknowledge is sent.
    CHECK(slow.message - usual.message == 5 * 1000 * cycle);
    CHECK(usual.message - free.message == 5 * 200 * cycle);
    CHECK(slow.computation - usual.computation == 2 * 2 * 1000 * cycle);
    CHECK_THROWS_WITH_AS(RoutedMachine(line(2), {.handling = Cycles{-1}}),
                         "the cycles in which a router handles a packet must not be negative", std::logic_error);
}
