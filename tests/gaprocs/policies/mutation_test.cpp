#include "gaprocs/policies/mutation.hpp"
#include "tests/gaprocs/strings.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace placedpar;
using test::ones_by_position;
using test::strings;

TEST_CASE("mutation flips bits at the stated rate, at every position alike") {
    RandomStream random(6, "mutation");
    std::vector<Genome> population(20000, Genome(50));
    BitMutation{}(population, random);
    auto ones = ones_by_position(population);
    int total = 0;
    for (int flips : ones) {
        CHECK(std::abs(flips - 200) < 66); // 4.7 standard deviations
        total += flips;
    }
    CHECK(std::abs(total - 10000) < 390); // 3.9 standard deviations
}

TEST_CASE("mutation never and always") {
    RandomStream random(7, "mutation");
    auto population = strings({"0110", "1111"});
    BitMutation{0}(population, random);
    CHECK(population == strings({"0110", "1111"}));
    BitMutation{1}(population, random);
    CHECK(population == strings({"1001", "0000"}));
}
