// Tests that two runs have different fingerprints if a communication differs in its partners, time or order.

#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using std::chrono::nanoseconds;

namespace {

/// Returns the fingerprint of a run with two messages at these times, on two channels.
std::uint64_t fingerprint(Time first, Time second) {
    Simulation simulation;
    Channel<int> a("a"), b("b");
    simulation.process("outputs a", [&] { wait_until(first), a.out().output(1); });
    simulation.process("outputs b", [&] { wait_until(second), b.out().output(1); });
    simulation.process("inputs a", [&] { a.in().input(); });
    simulation.process("inputs b", [&] { b.in().input(); });
    return simulation.run().fingerprint;
}

} // namespace

TEST_CASE("the same run has the same fingerprint, a constant on every machine") {
    CHECK(fingerprint(nanoseconds{1}, nanoseconds{2}) == fingerprint(nanoseconds{1}, nanoseconds{2}));
    CHECK(fingerprint(nanoseconds{1}, nanoseconds{2}) == 13611305818607772799u);
}

TEST_CASE("another time or another order of messages gives another fingerprint") {
    std::uint64_t one = fingerprint(nanoseconds{1}, nanoseconds{2});
    CHECK(fingerprint(nanoseconds{1}, nanoseconds{2} + Time{1}) != one);
    CHECK(fingerprint(nanoseconds{2}, nanoseconds{1}) != one);
    CHECK(fingerprint(nanoseconds{1}, nanoseconds{1}) != one);
}

TEST_CASE("processes created in another order give another fingerprint") {
    auto run = [](bool swapped) {
        Simulation simulation;
        Channel<int> c("c");
        auto outputs = [&] { c.out().output(1); };
        auto inputs = [&] { c.in().input(); };
        swapped ? simulation.process("i", inputs) : simulation.process("o", outputs);
        swapped ? simulation.process("o", outputs) : simulation.process("i", inputs);
        return simulation.run().fingerprint;
    };
    CHECK(run(false) != run(true));
}
