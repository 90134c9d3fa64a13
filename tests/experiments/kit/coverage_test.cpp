// Tests the bootstrap by what a 95 % interval promises: it contains the truth in about 95 of 100 studies.

#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/claims.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns values from a skew distribution, exp(normal), whose median is 1.
std::vector<double> skew_sample(std::size_t count, std::uint64_t study) {
    RandomStream random(study, "skew sample");
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(std::exp(random.normal()));
    return values;
}

std::vector<double> whole_numbers_to(int last) {
    std::vector<double> values(static_cast<std::size_t>(last));
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

std::vector<double> stretched(std::vector<double> values, double factor, double shift) {
    for (double& value : values)
        value = factor * value + shift;
    return values;
}

} // namespace

TEST_CASE("intervals of the median contain the true median in about 95 of 100 studies") {
    constexpr int studies = 200;
    int contained = 0;
    for (std::uint64_t study = 1; study <= studies; ++study)
        contained += median_interval(skew_sample(30, study)).contains(1);
    // With 200 studies the share has a standard deviation of 1.5 %, and the bootstrap itself is a little off 95 %.
    CHECK(contained >= 0.90 * studies);
    CHECK(contained <= 0.99 * studies);
}

TEST_CASE("intervals of a quotient of sums contain the true quotient in about 95 of 100 studies") {
    constexpr int studies = 200;
    int contained = 0;
    for (std::uint64_t study = 1; study <= studies; ++study) {
        const std::vector<double> below = skew_sample(60, study);
        std::vector<double> above = skew_sample(60, 1000 + study);
        for (std::size_t i = 0; i < above.size(); ++i)
            above[i] = 2 * below[i] + above[i] - std::exp(0.5); // exp(.5) is the mean of exp(normal)
        contained += quotient_interval(above, below).contains(2);
    }
    CHECK(contained >= 0.88 * studies);
    CHECK(contained <= 0.99 * studies);
}

TEST_CASE("a claim that is just true is refuted in at most a few of 100 studies") {
    int refuted = 0, decided = 0;
    for (std::uint64_t study = 1; study <= 100; ++study) {
        const Claim claim{.text = "x", .unit = "", .values = skew_sample(30, study), .at_least = 1, .at_most = {}};
        refuted += verdict_of(claim) == ClaimVerdict::fails;
        decided += verdict_of(claim) != ClaimVerdict::undecided;
    }
    CHECK(refuted <= 9); // 2.5 % are expected, that is 2.5 of 100, plus four standard deviations of 1.6
    CHECK(decided <= 14);
}

TEST_CASE("a claim that is clearly true or false is decided by thirty runs") {
    for (std::uint64_t study = 1; study <= 20; ++study) {
        const std::vector<double> values = skew_sample(30, study);
        CHECK(verdict_of({.text = "x", .unit = "", .values = values, .at_least = 0.2, .at_most = {}}) ==
              ClaimVerdict::holds);
        CHECK(verdict_of({.text = "x", .unit = "", .values = values, .at_least = 5, .at_most = {}}) ==
              ClaimVerdict::fails);
    }
}

TEST_CASE("the interval of a median is between order statistics: of 20 values, about the 6th to the 15th") {
    // The median of the distribution is between the 6th and the 15th of 20 values with a probability of 95.9 %.
    const Interval interval = median_interval(whole_numbers_to(20));
    CHECK(std::abs(interval.low - 6) <= 1);
    CHECK(std::abs(interval.high - 15) <= 1);
}

TEST_CASE("an interval moves and stretches with its values") {
    const std::vector<double> values = skew_sample(25, 7);
    const Interval interval = median_interval(values), moved = median_interval(stretched(values, 3, -10)),
                   turned = median_interval(stretched(values, -1, 0));
    CHECK(moved.low == doctest::Approx(3 * interval.low - 10));
    CHECK(moved.high == doctest::Approx(3 * interval.high - 10));
    CHECK(turned.low < 0); // the ends change their places
    CHECK(turned.high == doctest::Approx(-interval.low).epsilon(0.1));
    const std::vector<double> below(25, 2);
    const Interval quotient = quotient_interval(values, below),
                   tenfold = quotient_interval(stretched(values, 10, 0), below);
    CHECK(tenfold.low == doctest::Approx(10 * quotient.low));
    CHECK(tenfold.high == doctest::Approx(10 * quotient.high));
}

TEST_CASE("one outlier does not move the interval of a median, but that of a quotient of sums") {
    std::vector<double> values(30, 1), far = values;
    far[3] = 1e6;
    CHECK(median_interval(far).high == 1);
    const std::vector<double> below(30, 1);
    CHECK(quotient_interval(values, below).high == 1);
    CHECK(quotient_interval(far, below).high > 1e4);
}

TEST_CASE("an infinite value, such as that of a search without an end, keeps the median's interval finite") {
    std::vector<double> values = whole_numbers_to(30);
    values.back() = std::numeric_limits<double>::infinity();
    const Interval interval = median_interval(values);
    CHECK(std::isfinite(interval.low));
    CHECK(std::isfinite(interval.high));
    CHECK(interval.contains(15));
}

TEST_CASE("a table of claims prints the decimals that its bounds need, from two to six") {
    const auto decimals = [](double bound) {
        const Claim claim{
            .text = "x", .unit = "", .values = std::vector<double>(6, 1), .at_least = bound, .at_most = {}};
        return claims_comparison("claims", {claim}).cells.at(0).decimals;
    };
    CHECK(decimals(5) == 2);
    CHECK(decimals(0.25) == 2);
    CHECK(decimals(0.125) == 3);
    CHECK(decimals(0.0001) == 4);
    CHECK(decimals(1 / 3.0) == 6); // no number of decimals is exact
    CHECK(claims_comparison("no claims", {}).cells.empty());
    CHECK(name_of(ClaimVerdict::holds) == std::string("holds"));
    CHECK(name_of(ClaimVerdict::fails) == std::string("does not hold"));
    CHECK(name_of(ClaimVerdict::undecided) == std::string("undecided"));
}
