#include "identification/verdict/sequential_test.hpp"

#include "identification/verdict/way_matrices.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::identification;

namespace {

/// Returns a deviation whose leak was absent before the movement.
Deviation seen(double compliance, double leak, double offset, double error) {
    return {{compliance, leak, offset, 0}, two_ways_of(WayMatrix::Identity() * error * error)};
}

std::size_t movements_until_raised(const Deviation& each, std::size_t most = 100) {
    SequentialTest test;
    for (std::size_t i = 1; i <= most; ++i) {
        test.take(each, {});
        if (test.raised())
            return i;
    }
    return 0;
}

} // namespace

TEST_CASE("an alarm needs two movements, even for an obvious fault") {
    CHECK(movements_until_raised(seen(1, 0, 0, 0.01)) == 2);
    CHECK(movements_until_raised(seen(5, 0, 0, 0.01)) == 2);
    CHECK(movements_until_raised(seen(0, 0, -1, 0.01)) == 2);
}

TEST_CASE("more noise needs more movements") {
    // Each movement adds (1 - 1/2) / (s^2 + the variance between movements).
    for (double error : {0.5, 1.0, 2.0}) {
        double each = 0.5 / (error * error + repeats_within * repeats_within);
        CHECK(movements_until_raised(seen(1, 0, 0, error)) ==
              static_cast<std::size_t>(std::ceil(SequentialTest::raised_at / each)));
    }
}

TEST_CASE("deviations below half a unit and negative leaks raise no suspicion") {
    CHECK(movements_until_raised(seen(0.49, 0, 0, 0.1)) == 0);
    CHECK(movements_until_raised(seen(0, -1, 0, 0.1)) == 0);
}

TEST_CASE("an uncertain baseline delays the alarm, except for obvious faults") {
    auto until = [](double compliance, double error) {
        SequentialTest test;
        const Deviation health{{}, two_ways_of(WayMatrix::Identity() * 0.3 * 0.3)};
        for (std::size_t i = 1; i <= 20; ++i) {
            test.take(seen(compliance, 0, 0, error), health, {2, 2, 2, 2});
            if (test.raised())
                return i;
        }
        return std::size_t{0};
    };
    CHECK(until(5, 0.01) == 2); // the information of a movement is limited together with its ratio
    CHECK(until(2, 0.01) == 2);
    CHECK(until(2, 0.8) > 2);
    CHECK(until(1.2, 0.2) == 0); // within the spread of sound machines
}

TEST_CASE("an alarm is cleared by three sound movements") {
    SequentialTest test;
    for (int i = 0; i < 50; ++i)
        test.take(seen(1, 0, 0, 0.1), {});
    test.take(seen(0, 0, 0, 0.1), {});
    test.take(seen(0, 0, 0, 0.1), {});
    CHECK(test.raised());
    test.take(seen(0, 0, 0, 0.1), {});
    CHECK_FALSE(test.raised());
    test.take(seen(1, 0, 0, 0.1), {});
    CHECK_FALSE(test.raised()); // a single movement
    CHECK(test.state().movements == 1);
}

TEST_CASE("errors of the stated size cause few false alarms") {
    RandomStream random(1, "movements");
    auto normal = [&] {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += random.uniform();
        return sum;
    };
    int raised = 0;
    for (int machine = 0; machine < 500; ++machine) {
        SequentialTest test;
        bool ever = false;
        for (int movement = 0; movement < 20; ++movement) {
            test.take(seen(0.5 * normal(), 0.5 * normal(), 0.5 * normal(), 0.5), {});
            ever = ever || test.raised();
        }
        raised += ever;
    }
    MESSAGE(raised, " of 500 raised");
    CHECK(raised <= 10);
}
