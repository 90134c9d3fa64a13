#include "identification/change_test.hpp"
#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::identification;

namespace {

std::vector<UncertainValue> series_of(RandomStream& random, std::size_t size, std::size_t change_at, double by,
                                      double real_errors = 1) {
    std::vector<UncertainValue> series;
    for (std::size_t i = 0; i < size; ++i) {
        const double error = 0.5 + random.uniform();
        series.push_back({100 + (i >= change_at ? by : 0) + real_errors * error * random.normal(), error});
    }
    return series;
}

/// Returns how many of 300 series without a change have one at a level of 5 %.
std::size_t false_alarms(std::size_t size, double real_errors) {
    std::size_t count = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        RandomStream random(seed, "test");
        count += find_change(series_of(random, size, size, 0, real_errors), 0.05).has_value();
    }
    return count;
}

} // namespace

TEST_CASE("the test of change keeps its rate of false alarms") {
    // The rate is 5 %; of 300 series, 4 to 28 have a change with a probability of 99.9 %.
    for (std::size_t size : {2U, 12U}) {
        const std::size_t count = false_alarms(size, 1);
        CHECK(count >= 4);
        CHECK(count <= 28);
    }
    CHECK(false_alarms(12, 0.5) <= 15); // the standard errors are too large
    for (std::size_t size : {fewest_for_scatter, std::size_t{12}})
        CHECK(false_alarms(size, 3) <= 28); // the standard errors are too small, which the scatter shows
    for (std::size_t size : {3U, 4U})
        CHECK(false_alarms(size, 3) > 28); // a scatter of so few estimates does not show it
}

TEST_CASE("after a change, the scatter of the whole series judges the parts") {
    // Two parts are tested at 5 % each: of 300 series, up to 47 have a second change with a probability of 99.9 %.
    std::size_t second = 0, covered = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        RandomStream random(seed, "one change");
        const std::vector<SeriesChange> changes = find_changes(series_of(random, 12, 6, 60, 3), 0.05);
        REQUIRE(!changes.empty());
        second += changes.size() > 1;
        const auto& [at, before, after, probability] = changes.front();
        const double error = std::hypot(before.standard_error, after.standard_error);
        covered += std::abs(after.value - before.value - 60) <= 1.96 * error;
    }
    CHECK(second <= 47);
    CHECK(covered >=
          255); // an interval of 95 % that takes the scatter of 12 estimates as exact; by standard errors 49 %
    CHECK(covered < 300);
}

TEST_CASE("a change is found at its place, with its size") {
    RandomStream random(1, "test");
    const auto change = find_change(series_of(random, 12, 7, 10), 0.01);
    REQUIRE(change);
    CHECK(change->at == 7);
    CHECK(change->after.value - change->before.value == doctest::Approx(10).epsilon(0.15));
    CHECK(change->before.standard_error < 0.5);
    CHECK(change->probability == 0.0001);
    CHECK(!find_change({}, 0.01));
    CHECK(!find_change({{1, 0.1}}, 0.01));
    CHECK(!find_change({{1, 0.1}, {1, 0.1}}, 0.01));
    CHECK(find_change({{1, 0.1}, {2, 0.1}}, 0.01));
}

TEST_CASE("two changes are found, and the means extend from change to change") {
    RandomStream random(2, "test");
    std::vector<UncertainValue> series = series_of(random, 15, 5, 20);
    for (std::size_t i = 10; i < 15; ++i)
        series[i].value += 30;
    const std::vector<SeriesChange> changes = find_changes(series, 0.01);
    REQUIRE(changes.size() == 2);
    CHECK(changes[0].at == 5);
    CHECK(changes[1].at == 10);
    CHECK(changes[0].after.value == changes[1].before.value);
    CHECK(changes[0].before.value == doctest::Approx(100).epsilon(0.02));
    CHECK(changes[1].after.value == doctest::Approx(150).epsilon(0.02));
}
