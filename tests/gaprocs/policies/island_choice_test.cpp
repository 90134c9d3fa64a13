#include "gaprocs/policies/island_choice.hpp"

#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace placedpar;
using Sum = ErrorMatrix::Sum;
using Normaliser = ErrorMatrix::Normaliser;

namespace {

/// Returns random errors of four islands, whose order of magnitude changes from sample to sample.
ErrorsOfBest any_errors(std::uint64_t seed) {
    RandomStream random(seed, "errors");
    ErrorsOfBest bests{{30, 24, 16, 10}, {}};
    for (std::size_t island = 0; island < 4; ++island) {
        std::vector<double> errors;
        double size = 1;
        for (std::size_t k = 0; k < 30; ++k) {
            size *= std::exp(3 * (random.uniform() - 0.5));
            errors.push_back(size * (random.uniform() - 0.5));
        }
        bests.errors.push_back(errors);
    }
    return bests;
}

/// Two islands with windows of 4 and 2 samples.
const ErrorsOfBest small_matrix{{4, 2}, {{1, -1, 2, 2}, {3, 1, 1, -1}}};

} // namespace

TEST_CASE("the error matrix of two islands has the values computed by hand") {
    ErrorMatrix squares(small_matrix, Sum::squares), plain(small_matrix, Sum::plain), means(small_matrix, Sum::means);
    CHECK(squares.error(0, 0) == 10);
    CHECK(squares.error(0, 1) == 12);
    CHECK(squares.error(1, 0) == 8);
    CHECK(squares.error(1, 1) == 2);
    CHECK(plain.error(0, 0) == 4);
    CHECK(plain.error(0, 1) == 4);
    CHECK(plain.error(1, 0) == 4);
    CHECK(plain.error(1, 1) == 0);
    CHECK(means.error(0, 0) == 2.5);
    CHECK(means.error(1, 0) == 4);
    // These are equations 5.3 and 5.4 as printed.
    CHECK(squares.sum_over_windows(0, Normaliser::column) == doctest::Approx((10. + 8) / 10));
    CHECK(squares.sum_over_windows(1, Normaliser::column) == doctest::Approx((12. + 2) / 2));
    CHECK(squares.sum_over_islands(0, Normaliser::column) == doctest::Approx(10. / 10 + 12. / 2));
    CHECK(squares.sum_over_islands(1, Normaliser::column) == doctest::Approx(8. / 10 + 2. / 2));
    CHECK(squares.ratio(0, Normaliser::column) == doctest::Approx(7 / 1.8));
    // Each error is divided by the row's own error.
    CHECK(squares.sum_over_windows(0, Normaliser::row) == doctest::Approx(10. / 10 + 8. / 2));
    CHECK(squares.sum_over_islands(1, Normaliser::row) == doctest::Approx(8. / 2 + 2. / 2));
    CHECK(means.ratio(0, Normaliser::row) == doctest::Approx(squares.ratio(0, Normaliser::row)));
    CHECK(means.ratio(1, Normaliser::row) == doctest::Approx(squares.ratio(1, Normaliser::row)));
}

TEST_CASE("by the printed rule, Sw never rises from the longest window to the shortest, which contradicts 5.5") {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        ErrorMatrix matrix(any_errors(seed), Sum::squares);
        for (std::size_t i = 1; i < 4; ++i)
            CHECK(matrix.sum_over_islands(i - 1, Normaliser::column) >= matrix.sum_over_islands(i, Normaliser::column));
    }
}

TEST_CASE("by the printed rule, the shortest window is never preferred to the longest") {
    RandomStream random(1, "not drawn from");
    std::array<int, 4> chosen{};
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        ErrorsOfBest bests = any_errors(seed);
        ErrorMatrix matrix(bests, Sum::squares);
        CHECK(matrix.sum_over_windows(0, Normaliser::column) <= 4);
        CHECK(matrix.sum_over_windows(3, Normaliser::column) >= 4);
        CHECK(matrix.ratio(0, Normaliser::column) >= 1);
        CHECK(matrix.ratio(3, Normaliser::column) <= 1);
        ++chosen[PrintedChoice{}(bests, random)];
    }
    CHECK(chosen[3] == 0);
    // Other windows than the longest are chosen, too.
    CHECK(chosen[0] > 0);
    CHECK(chosen[1] + chosen[2] > 0);
}

TEST_CASE("each of the other rules can choose every window") {
    RandomStream random(1, "draws");
    for (const char* name : {"plain", "means", "row", "random"}) {
        std::array<int, 4> chosen{};
        for (std::uint64_t seed = 0; seed < 2000; ++seed)
            ++chosen[IslandChoice::named(name)(any_errors(seed), random)];
        for (int count : chosen)
            CHECK_MESSAGE(count > 0, name);
    }
}

TEST_CASE("the choice \"row\" prefers the island with the short window, if only this island has followed a change") {
    // Only island 3 fits the ten samples after a change; the others fit the twenty samples before it.
    ErrorsOfBest bests{{30, 24, 16, 10}, {}};
    for (std::size_t island = 0; island < 4; ++island) {
        std::vector<double> errors(30, island == 3 ? 1 : 0.01);
        for (std::size_t k = 20; k < 30; ++k)
            errors[k] = island == 3 ? 0.01 : 1;
        bests.errors.push_back(errors);
    }
    RandomStream random(1, "not drawn from");
    CHECK(RowChoice{}(bests, random) == 3);
    CHECK(PrintedChoice{}(bests, random) == 0);
}

TEST_CASE("the choice \"row\" does not choose an island whose errors are infinite, huge or not a number") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    RandomStream random(1, "not drawn from");
    for (double wrong : {nan, infinity, -infinity, 1e300}) {
        CAPTURE(wrong);
        // Only the island with the shortest window fits the two samples after a change.
        ErrorsOfBest bests{{4, 3, 2}, {{wrong, wrong, wrong, wrong}, {.01, .01, 1, 1}, {1, 1, .01, .01}}};
        CHECK(IslandChoice::named("row")(bests, random) == 2);
        ErrorMatrix matrix(bests, Sum::squares);
        for (auto normaliser : {Normaliser::row, Normaliser::column})
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(std::isfinite(matrix.ratio(i, normaliser)));
    }
}

TEST_CASE("of two islands without errors, the first is chosen") {
    ErrorsOfBest bests{{2, 1}, {{0, 0}, {0, 0}}};
    RandomStream random(1, "not drawn from");
    for (const char* name : {"printed", "plain", "means", "row"})
        CHECK(IslandChoice::named(name)(bests, random) == 0);
    CHECK(ErrorMatrix(bests, Sum::squares).ratio(1, Normaliser::column) == 1);
}

TEST_CASE("a fixed choice always chooses the same island, which must exist") {
    RandomStream random(1, "not drawn from");
    CHECK(IslandChoice::named("fixed(1)")(small_matrix, random) == 1);
    CHECK_THROWS_WITH_AS(IslandChoice::named("fixed(island = 2)")(small_matrix, random),
                         "the choice is island 2, but the number of islands is 2; expected an island from 0 to 1",
                         UserError);
    CHECK(IslandChoice::named("fixed(1)").text() == "fixed(island = 1)");
    CHECK(IslandChoice().text() == "printed");
}
