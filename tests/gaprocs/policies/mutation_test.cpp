#include "gaprocs/policies/mutation.hpp"
#include "tests/gaprocs/strings.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>

using namespace placedpar;
using test::ones_by_position;
using test::strings;

TEST_CASE("mutation flips bits at the stated rate, equally at every position") {
    for (const Mutation& mutation : {Mutation(BitMutation{}), Mutation(DistanceMutation{})}) {
        CAPTURE(mutation.text());
        RandomStream random(6, "mutation");
        std::vector<Genome> population(20000, Genome(50));
        mutation(population, 0.01, BitString(50), random);
        auto ones = ones_by_position(population);
        int total = 0;
        for (int flips : ones) {
            CHECK(std::abs(flips - 200) < 66); // 4.7 standard deviations
            total += flips;
        }
        CHECK(std::abs(total - 10000) < 390); // 3.9 standard deviations
    }
}

TEST_CASE("flips of neighbouring bits and of successive strings are independent") {
    for (const Mutation& mutation : {Mutation(BitMutation{}), Mutation(DistanceMutation{})}) {
        CAPTURE(mutation.text());
        RandomStream random(8, "mutation");
        std::vector<Genome> population(20000, Genome(2));
        mutation(population, 0.3, BitString(2), random);
        std::array<int, 4> seen{};
        for (const Genome& genome : population)
            ++seen.at(genome.field(0, 2));
        double chi_squared = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            double expected = 20000 * (i & 2 ? 0.3 : 0.7) * (i & 1 ? 0.3 : 0.7);
            chi_squared += (seen.at(i) - expected) * (seen.at(i) - expected) / expected;
        }
        CHECK(chi_squared < 16.3); // 3 degrees of freedom, 99.9 %
    }
}

TEST_CASE("mutation with probability 0 flips no bit, and with probability 1 flips all bits") {
    for (const Mutation& mutation : {Mutation(BitMutation{}), Mutation(DistanceMutation{})}) {
        CAPTURE(mutation.text());
        RandomStream random(7, "mutation");
        auto population = strings({"0110", "1111"});
        mutation(population, 0, BitString(4), random);
        CHECK(population == strings({"0110", "1111"}));
        mutation(population, 1, BitString(4), random);
        CHECK(population == strings({"1001", "0000"}));
        std::vector<Genome> nothing;
        mutation(nothing, 0.5, BitString(4), random);
    }
}

TEST_CASE("distance mutation draws one number for each flip and one more") {
    RandomStream random(9, "mutation"), same(9, "mutation");
    std::vector<Genome> population(100, Genome(37));
    DistanceMutation{0.01}(population, random);
    int flips = 0;
    for (int ones : ones_by_position(population))
        flips += ones;
    REQUIRE(flips > 0);
    for (int i = 0; i <= flips; ++i)
        same();
    CHECK(random() == same());
}
