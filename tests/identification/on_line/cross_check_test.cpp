#include "identification/on_line/cross_check.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

double spread_of(std::initializer_list<double> compliances) {
    LinkCheck check;
    for (double each : compliances)
        check.estimates.push_back({{Link::boom}, each, each, 3, 1});
    return check.spread();
}

} // namespace

TEST_CASE("the spread between population sets is computed") {
    CHECK(spread_of({}) == 0);
    CHECK(spread_of({2}) == 0);
    CHECK(spread_of({1, 1.5, 1.2}) == doctest::Approx(0.5 / 1.2));
}
