#include "experiments/chapter_3/kit/spool_lag.hpp"
#include "tests/nearly.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

double found_while_rising(const BoomData& data, const BoomModel& model) {
    UsableSamples rising;
    rising.rising = true;
    return least_squares_compliance(data, model, rising).value();
}

} // namespace

TEST_CASE("the lag that finds the true compliance is the machine's own lag") {
    BoomData data = measure({BoomPlant::simple}, 1);
    double found = found_while_rising(data, model_of(data, AreasFrom::servo));
    CHECK(lag_that_finds(found, data) == doctest::Approx(data.boom.spool_lag_per_s).epsilon(1e-3));
}

TEST_CASE("the lag that finds a compliance does find it") {
    BoomData data = measure({BoomPlant::simple}, 1);
    CHECK(found_while_rising(data, {AreasFrom::servo, lag_that_finds(0.011, data), 0}) == test::nearly(0.011, 0.001));
}

TEST_CASE("a compliance that no lag finds is refused") {
    BoomData data = measure({BoomPlant::simple}, 1);
    CHECK_THROWS_AS(lag_that_finds(0.09, data), UserError);
}
