// Tests that the judge of "almost identical" passes equal algorithms and fails unequal ones.

#include "experiments/chapter_4/kit/parallel_identification.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

namespace {

constexpr double truth = 0.0086;

/// Results of a traditional algorithm on 100 records, scattered by up to 4 %, and of a parallel one, by up to 4.5 %.
BothFound equal_algorithms() {
    BothFound found{truth, {}, {}};
    for (int record = 0; record < 100; ++record) {
        double scatter = 0.02 * (record % 5 - 2), other = 0.015 * (record % 7 - 3);
        found.traditional.push_back({truth * (1 + scatter), 10.0 + record % 5, 1});
        found.parallel.push_back({truth * (1 + other), 10.0 + record % 5, 1});
    }
    return found;
}

/// Returns the number of cells that miss their bounds.
auto misses(const BothFound& found) {
    return std::ranges::count_if(cells_of_difference(found, "PGA"),
                                 [](const Cell& cell) { return !cell.within_tolerance(); });
}

} // namespace

TEST_CASE("an algorithm that finds what the traditional one finds is almost identical") {
    CHECK(cells_of_difference(equal_algorithms(), "PGA").size() == 3);
    CHECK(misses(equal_algorithms()) == 0);
}

TEST_CASE("compliances that are 4 % too high or too low are not almost identical") {
    for (double factor : {0.96, 1.04}) {
        BothFound biased = equal_algorithms();
        for (FoundInRecord& each : biased.parallel)
            each.compliance_in3_per_psi *= factor;
        CHECK(misses(biased) == 1);
    }
}

TEST_CASE("an algorithm that fails in one record of six, and converges two samples later, is not almost identical") {
    BothFound worse = equal_algorithms();
    for (std::size_t record = 0; record < worse.parallel.size(); ++record) {
        FoundInRecord& each = worse.parallel[record];
        each.generations += 10;
        if (record % 6 == 0) // half of the failures are too high, half too low: the mean stays right
            each.compliance_in3_per_psi = truth * (record % 12 == 0 ? 1.3 : 0.7);
    }
    CHECK(misses(worse) == 2);
}
