// The closed form of links against every byte, where everything meets that links have to do with.

#include "random_machine.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// How often each thing was done in them, by the first words of its entry in the log.
using Tally = std::map<std::string, std::uint64_t>;

Tally compare_random_machines(const std::vector<std::uint64_t>& seeds) {
    Tally tally;
    for (std::uint64_t seed : seeds) {
        INFO(replay(seed));
        RandomMachine bytes(seed, true), closed(seed, false);
        RunResult by_bytes = bytes.run(), by_form = closed.run();
        REQUIRE(by_form.ending == by_bytes.ending);
        REQUIRE(by_form.time == by_bytes.time);
        REQUIRE(by_form.fingerprint == by_bytes.fingerprint);
        REQUIRE(std::ranges::equal(closed.log(), bytes.log()));
        for (const auto& [time, what, value] : closed.log())
            ++tally[what.substr(0, what.find(" on "))];
        for (const std::string& feature : closed.features())
            ++tally[feature];
    }
    return tally;
}

} // namespace

TEST_CASE("random machines and programs do the same, to the picosecond, with the closed form and with every byte") {
    constexpr std::uint64_t machines = sanitized ? 50 : 400;
    Tally tally = compare_random_machines(seeds(machines));
    if (!all_seeds())
        return;
    for (const char* what : {"has sent", "has received", "has received in time", "has given up output",
                             "has given up input", "has chosen", "has computed", "memory", "trace: carries"}) {
        CAPTURE(what);
        CHECK(tally[what] > machines / 2);
    }
    for (const char* what : {"faults", "switch", "packets", "computing"}) {
        CAPTURE(what);
        CHECK(tally[what] > machines / 10);
    }
}

TEST_CASE("random machines that once made a difference make none") {
    compare_random_machines({252,      // an acknowledge asked for early, and its receiver gave up
                             3'261,    // a byte that began before its link repeated itself, at another distance
                             35'143,   // a direction that was taken for alone on its link
                             35'828,   // an acknowledge asked for at the moment of a reset
                             46'960}); // given up at both ends while the end of a part was on the wire
}

TEST_CASE("a hundred thousand of them do" * doctest::skip()) {
    Tally tally = compare_random_machines(seeds(100'000, 1'000));
    if (all_seeds())
        CHECK(tally["has sent"] > 1'000'000);
}
