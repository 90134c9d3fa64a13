// Tests arrays of channels.

#include "runtime/alternation.hpp"
#include "runtime/channels.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <concepts>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

Channels<int> made_elsewhere(std::size_t count) { return Channels<int>("c", count); }

template <class Array>
constexpr bool ends_of_a_temporary = requires {
    Array("c", 2).in();
}
|| requires { Array("c", 2).out(); };

static_assert(!std::copy_constructible<Channels<int>> && std::movable<Channels<int>>);
static_assert(!ends_of_a_temporary<Channels<int>>);

} // namespace

TEST_CASE("an array of channels names its channels and refuses a subscript beyond its end") {
    Channels<int> c = made_elsewhere(3);
    CHECK(c.size() == 3);
    CHECK(c[2].name() == "c[2]");
    CHECK_THROWS_AS(c[3], std::out_of_range);
    CHECK(Channels<int>().size() == 0);
    std::size_t counted = 0;
    for (Channel<int>& each : c)
        counted += each.name().size();
    CHECK(counted == 12);
}

TEST_CASE("an array that is moved keeps its channels, also while a process is in one of them") {
    Simulation simulation;
    std::vector<Channels<int>> rows;
    rows.push_back(made_elsewhere(2));
    std::vector<int> received;
    simulation.process("outputs", [ends = rows[0].out()]() mutable {
        for (std::size_t i = 0; i < ends.size(); ++i)
            ends[i].output(static_cast<int>(10 * i));
    });
    simulation.process("moves, and inputs", [&] {
        wait_for(std::chrono::microseconds{1}); // now the other process waits in c[0]
        Channels<int> moved = std::move(rows[0]);
        CHECK(rows[0].size() == 0);
        rows.resize(20);
        rows[19] = std::move(moved);
        for (Channel<int>& each : rows[19])
            received.push_back(each.in().input());
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(received == std::vector<int>{0, 10});
}

TEST_CASE("a replicated ALT may have an array of channels, each on a link") {
    Simulation simulation;
    Channels<int> c("c", 3);
    for (Channel<int>& each : c)
        each.put_on(simulation.add<hardware::Link>().from_a_to_b());
    int sum = 0;
    simulation.process("outputs",
                       [&c] { par_for(c.size(), [&](std::size_t i) { c[i].out().output(static_cast<int>(i) + 1); }); });
    simulation.process("inputs", [&] {
        std::vector<Input<int>> inputs = c.in();
        for (std::size_t n = 0; n < inputs.size(); ++n)
            alt(std::span<const Input<int>>(inputs), [&](std::size_t i, int message) {
                CHECK(message == static_cast<int>(i) + 1);
                sum += message;
            });
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(sum == 6);
}

TEST_CASE("a hard channel, and an array of them, can be made on their links") {
    Simulation simulation;
    hardware::Link &a = simulation.add<hardware::Link>(), &b = simulation.add<hardware::Link>();
    Channels<int> to("to", {a.from_a_to_b(), b.from_a_to_b()});
    Channel<int> back("back", a.from_b_to_a());
    REQUIRE(to.size() == 2);
    int sum = 0;
    simulation.process("master", [&] {
        for (int i = 0; i < 2; ++i)
            to[static_cast<std::size_t>(i)].out().output(i + 1);
        sum += back.in().input();
    });
    simulation.process("slave[0]", [&] { back.out().output(10 * to[0].in().input()); });
    simulation.process("slave[1]", [&] { sum += to[1].in().input(); });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(sum == 12);
    CHECK(a.from_a_to_b().bytes_carried() == sizeof(int));
    CHECK(b.from_a_to_b().bytes_carried() == sizeof(int));
    CHECK(a.from_b_to_a().bytes_carried() == sizeof(int));
}
