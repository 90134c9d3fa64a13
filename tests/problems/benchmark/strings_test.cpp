#include "gaprocs/objective_problem.hpp"
#include "problems/benchmark/strings.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the greatest objective of all strings.
template <class Problem>
double greatest_of_all(const Problem& problem) {
    std::size_t bits = problem.representation().bits();
    double greatest = -1;
    for (std::uint64_t code = 0; code < std::uint64_t{1} << bits; ++code) {
        Genome genome(bits);
        genome.set_field(0, bits, code);
        greatest = std::max(greatest, problem.objective(genome));
    }
    return greatest;
}

NkLandscape nk(std::size_t bits, std::size_t k, std::size_t seed) {
    NkLandscape numbers;
    numbers.bits = bits;
    numbers.k = k;
    numbers.seed = seed;
    return numbers;
}

} // namespace

TEST_CASE("OneMax counts ones, of any length") {
    OneMax ones{.bits = 12};
    CHECK(greatest_of_all(ones) == ones.optimum());
    CHECK(ones.objective(Genome::from_string("010110000001")) == 4);
    OneMax many{.bits = 4096};
    Genome genome(4096);
    CHECK(many.objective(genome) == 0);
    for (std::size_t i = 0; i < 4096; ++i)
        genome.flip(i);
    CHECK(many.objective(genome) == many.optimum());
}

TEST_CASE("a trap rewards zeros until all are ones") {
    Trap traps{.blocks = 2, .size = 4};
    CHECK(traps.objective(Genome::from_string("00000001")) == 3 + 2);
    CHECK(traps.objective(Genome::from_string("11110111")) == 4 + 0);
    CHECK(traps.objective(Genome::from_string("00110101")) == 1 + 1);
    CHECK(greatest_of_all(traps) == traps.optimum());
    Trap wide{.blocks = 3, .size = 64};
    CHECK(wide.objective(Genome(192)) == 3 * 63);
}

TEST_CASE("an NK landscape agrees with a hand computation") {
    // Bits i and i + 1 choose one of four numbers; the three bits form a ring.
    Landscape landscape(3, 1, {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048});
    CHECK(landscape.objective(Genome::from_string("000")) == 1 + 16 + 256);
    CHECK(landscape.objective(Genome::from_string("011")) == 2 + 128 + 1024);
    CHECK(landscape.objective(Genome::from_string("100")) == 4 + 16 + 512);
    CHECK(landscape.optimum() == 8 + 128 + 2048);
}

TEST_CASE("the optimum of an NK landscape is the best of all strings, for any number of neighbours") {
    for (std::size_t bits : {1u, 2u, 5u, 10u})
        for (std::size_t k = 0; k < std::min<std::size_t>(bits, 9); ++k)
            for (std::size_t seed : {1u, 2u}) {
                CAPTURE(bits);
                CAPTURE(k);
                Landscape landscape = nk(bits, k, seed).problem();
                CHECK(landscape.optimum().value() == doctest::Approx(greatest_of_all(landscape)).epsilon(1e-12));
            }
    CHECK(nk(10, 3, 1).problem().optimum() != nk(10, 3, 2).problem().optimum());
    CHECK(nk(64, 2, 1).problem().optimum().value() < 1);
}

TEST_CASE("the optimum of a large NK landscape is not computed, and too many neighbours are refused") {
    CHECK_FALSE(nk(10000, 8, 1).problem().optimum());
    CHECK_THROWS_WITH_AS(nk(4, 4, 1).problem(),
                         "k = 4, but bits = 4: a bit can have at most 3 of the other bits as neighbours", UserError);
}
