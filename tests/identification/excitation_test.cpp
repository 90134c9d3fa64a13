// Tests the estimate when the motion no longer excites the compliance (end of thesis 3.2).
#include "boom_records.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

constexpr std::uint64_t seeds = 50;
constexpr double truth = 0.0086;

/// Searches during four seconds of motion. All samples are usable, with 5 generations per sample.
Identified follow(IdentificationWay way, std::uint64_t seed) {
    way.usable.count = 150;
    return identify_boom(boom_measured(4, low_noise, seed), way, seed);
}

const TransientEstimate& at_generation(const Identified& identified, std::size_t generation) {
    return identified.estimates.at(generation / 5 - 1);
}

} // namespace

TEST_CASE("without the gate the estimate is lost by generation 400, as the thesis observed after 425") {
    std::vector<double> early, late;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Identified identified = follow(thesis_way(), seed);
        early.push_back(error_percent(at_generation(identified, 50).compliance_in3_per_psi[0], truth));
        late.push_back(error_percent(at_generation(identified, 400).compliance_in3_per_psi[0], truth));
    }
    CHECK(lower_median(early) <= 3.5);
    CHECK(lower_median(late) >= 30);
}

TEST_CASE("with the gate the estimate stays accurate, and is frozen to the bit") {
    std::vector<double> errors;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        IdentificationWay way = thesis_way();
        way.gate.emplace();
        Identified identified = follow(way, seed);
        REQUIRE(identified.estimates.back().frozen);
        auto last_live = std::find_if(identified.estimates.rbegin(), identified.estimates.rend(),
                                      [](const TransientEstimate& estimate) { return !estimate.frozen; });
        CHECK(identified.estimates.back().compliance_in3_per_psi == last_live->compliance_in3_per_psi);
        errors.push_back(error_percent(identified.estimates.back().compliance_in3_per_psi[0], truth));
    }
    CHECK(quantile(errors, 0.9) <= 12);
}

TEST_CASE("a frozen search evaluates nothing") {
    IdentificationWay way = thesis_way();
    way.gate.emplace();
    Identified identified = follow(way, 1);
    auto live = static_cast<std::uint64_t>(

        std::count_if(identified.estimates.begin(), identified.estimates.end(),
                      [](const TransientEstimate& estimate) { return !estimate.frozen; }));
    CHECK(identified.generations == 5 * live);
    CHECK(live < identified.estimates.size());
}
