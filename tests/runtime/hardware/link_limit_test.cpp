// Tests the statistics of a link whose run is stopped in the middle of a message.

#include "runtime/hardware/link.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <utility>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;

namespace {

struct LongBlock {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

struct Done {
    std::uint64_t bytes;
    Time occupied;
    bool operator==(const Done&) const = default;
};

/// Returns the progress of a message of 50 bytes, and of a message of 3 bytes that begins meanwhile in the other
/// direction.
std::pair<Done, Done> done_until(Time limit, bool every_byte, bool other_direction = true) {
    Simulation simulation;
    Link& link = simulation.add<Link>(LinkTiming{});
    Channel<LongBlock> there("there"), back("back");
    if (every_byte)
        for (LinkDirection* direction : {&link.from_a_to_b(), &link.from_b_to_a()})
            direction->simulate_every_byte();
    there.put_on(link.from_a_to_b());
    back.put_on(link.from_b_to_a());
    simulation.process("sender", [&] { there.out().output(LongBlock{50}); });
    simulation.process("receiver", [&] { there.in().input(); });
    if (other_direction) {
        simulation.process("late sender", [&] { wait_for(17us), back.out().output(LongBlock{3}); });
        simulation.process("late receiver", [&] { back.in().input(); });
    }
    std::pair<Done, Done> done;
    simulation.run(limit, [&] {
        auto said_by = [](const LinkDirection& d) { return Done{d.bytes_carried(), d.time_occupied()}; };
        done = {said_by(link.from_a_to_b()), said_by(link.from_b_to_a())};
    });
    return done;
}

} // namespace

TEST_CASE("a link that is stopped counts the bytes that have begun, and the elapsed time of the last one") {
    constexpr Time bit = 50ns, step = test::sanitized ? 490ns : 10ns;
    Time before{0};
    for (Time limit{0}; limit < 60us; limit += step) {
        for (bool other_direction : {false, true})
            REQUIRE(done_until(limit, true, other_direction) == done_until(limit, false, other_direction));
        Done done = done_until(limit, false).first;
        REQUIRE(done.occupied >= before);
        REQUIRE(done.occupied - before <= step);
        auto bytes = static_cast<std::int64_t>(done.bytes);
        REQUIRE(done.occupied <= bytes * 11 * bit);
        REQUIRE(done.occupied >= (bytes - 1) * 11 * bit);
        before = done.occupied;
    }
    CHECK(done_until(60us, false) == std::pair(Done{50, 50 * 11 * bit}, Done{3, 3 * 11 * bit}));
}
