#include "gaprocs/fitness.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value); }

void shuffle(std::vector<double>& terms, RandomStream& random) {
    for (std::size_t i = terms.size(); i > 1; --i)
        std::swap(terms[i - 1], terms[random.below(static_cast<std::uint32_t>(i))]);
}

/// Divides the terms into random groups of consecutive terms, adds up each group, and adds the sums in random order.
double partitioned_sum(const std::vector<double>& terms, RandomStream& random) {
    std::vector<double> partial(1, 0);
    for (double term : terms) {
        if (random.chance(0.1))
            partial.push_back(0);
        partial.back() += term;
    }
    shuffle(partial, random);
    double sum = 0;
    for (double part : partial)
        sum += part;
    return sum;
}

double any_error(RandomStream& random) {
    switch (random.below(8)) {
    case 0: return 1e300; // beyond the limit
    case 1: return std::numeric_limits<double>::quiet_NaN();
    case 2: return 2896 * random.uniform(); // around the limit
    case 3: return 1e-6 * random.uniform();
    default: return 40 * random.uniform();
    }
}

} // namespace

TEST_CASE("a term is B - E^2, rounded to the nearest quantum") {
    CHECK(fitness_term(400, 0) == 400);
    CHECK(fitness_term(400, 20) == 0);
    CHECK(fitness_term(400, -30) == -500);
    RandomStream random(1, "terms");
    for (int i = 0; i < 10000; ++i) {
        double error = 100 * random.uniform(), term = fitness_term(400, error);
        REQUIRE(std::abs(term - (400 - error * error)) <= fitness_quantum / 2);
        REQUIRE(std::nearbyint(term / fitness_quantum) == term / fitness_quantum);
    }
}

TEST_CASE("ties round to even") {
    CHECK(fitness_term(0.5 * fitness_quantum, 0) == 0);
    CHECK(fitness_term(1.5 * fitness_quantum, 0) == 2 * fitness_quantum);
    CHECK(fitness_term(2.5 * fitness_quantum, 0) == 2 * fitness_quantum);
}

TEST_CASE("a term outside the limits or not a number is replaced by a limit") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(fitness_term(400, std::numeric_limits<double>::quiet_NaN()) == -fitness_term_limit);
    CHECK(fitness_term(400, infinity) == -fitness_term_limit);
    CHECK(fitness_term(400, -infinity) == -fitness_term_limit);
    CHECK(fitness_term(400, 1e200) == -fitness_term_limit);
    CHECK(fitness_term(1e9, 0) == fitness_term_limit);
}

TEST_CASE("1024 terms give the same sum, bit for bit, however they are divided and ordered") {
    RandomStream random(2, "partitions");
    for (int i = 0; i < 200; ++i) {
        std::vector<double> terms;
        for (std::size_t w = 0; w < exact_fitness_terms; ++w)
            terms.push_back(fitness_term(400, any_error(random)));
        std::uint64_t expected = bits_of(partitioned_sum(terms, random));
        for (int j = 0; j < 20; ++j) {
            shuffle(terms, random);
            REQUIRE(bits_of(partitioned_sum(terms, random)) == expected);
        }
    }
}

TEST_CASE("a sum of 1024 terms at the limit still changes by one quantum") {
    double sum = 0;
    for (std::size_t w = 1; w < exact_fitness_terms; ++w)
        sum += -fitness_term_limit;
    double before = sum;
    sum += -fitness_term_limit + fitness_quantum;
    CHECK(before - sum == fitness_term_limit - fitness_quantum);
}
