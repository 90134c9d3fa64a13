// Tests that the results of a network of emulated transputers depend on the programs alone.

#include "random_network.hpp"

#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// Returns how far to run ahead: from a fraction of an instruction to longer than most programs.
Time random_ahead(std::uint64_t seed) {
    RandomStream random(seed, "ahead");
    return Time{1} + Time{random.below(1000)} * (std::int64_t{1} << random.below(22));
}

} // namespace

TEST_CASE("random networks do not depend on how far a transputer runs ahead, nor on the order in which it was made") {
    for (const std::uint64_t seed : seeds(150)) {
        INFO(replay(seed));
        const RandomNetwork network = random_network(seed);
        const std::vector<NodeOutcome> usual = run_network(network, {});
        CHECK_EQ(difference_of(usual, run_network(network, {.instruction_by_instruction = true})), "");
        CHECK_EQ(difference_of(usual, run_network(network, {.ahead_by = random_ahead(seed)})), "");
        CHECK_EQ(difference_of(usual, run_network(network, {.order = seed + 1})), "");
        CHECK_EQ(difference_of(usual, run_network(network, {.order = seed + 1, .every_byte = true})), "");
    }
}

TEST_CASE("a run that a limit stops has done what was to be done until then, and no more") {
    std::vector<std::uint64_t> cases = seeds(60);
    if (all_seeds()) // links that take nearly all accesses to a slow memory; one that acts shortly before the limit
        cases.insert(cases.end(), {12323, 70073, 12723});
    for (const std::uint64_t seed : cases) {
        INFO(replay(seed));
        const RandomNetwork network = random_network(seed);
        RandomStream random(seed, "limit");
        for (std::uint64_t i = 0; i < 5; ++i) {
            const Time until{random.below(800'000'000)}; // 0.8 ms
            CAPTURE(until.count());
            const std::vector<NodeOutcome> usual = run_network(network, {.until = until});
            CHECK_EQ(difference_of(usual, run_network(network, {.instruction_by_instruction = true, .until = until})),
                     "");
            CHECK_EQ(difference_of(usual, run_network(network, {.ahead_by = random_ahead(seed + i), .until = until})),
                     "");
            for (const NodeOutcome& node : usual)
                CHECK_LE(node.time_busy, until);
        }
    }
}
