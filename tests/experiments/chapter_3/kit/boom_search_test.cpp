#include "experiments/chapter_3/kit/boom_search.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

TEST_CASE("watching a search changes no bit of it") {
    IdentificationWay other = thesis_way();
    other.coding = Coding::gray;
    other.search.elite = 1;
    for (const IdentificationWay& way : {thesis_way(), other})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            BoomData data = measure({BoomPlant::simple, mid_noise}, seed);
            auto identified = identify_boom(data, model_of(data, AreasFrom::spool), way, seed);
            auto generations = watch_search(data, identified.samples, way, seed);
            REQUIRE(generations.size() == identified.found.generations);
            for (std::size_t i = 0; i < identified.found.estimates.size(); ++i) {
                const Generation& last = generations[(i + 1) * way.search.window.trials - 1];
                CHECK(last.best_in3_per_psi == identified.found.estimates[i].compliance_in3_per_psi[0]);
                CHECK(last.time_s == identified.found.estimates[i].time_s);
                CHECK(last.mean_error_in3_per_s > 0);
            }
        }
}

TEST_CASE("the population's mean error falls from the error of random strings in the first generations") {
    BoomData data = measure({BoomPlant::simple, low_noise}, 1);
    auto identified = identify_boom(data, model_of(data, AreasFrom::spool), thesis_way(), 1);
    auto generations = watch_search(data, identified.samples, thesis_way(), 1);
    CHECK(generations.front().mean_error_in3_per_s > 50);
    CHECK(generations[4].mean_error_in3_per_s < 15);
}

TEST_CASE("least squares reports a negative compliance, and the search flags it") {
    IdentificationWay rising = thesis_way();
    rising.usable.rising = true;
    BoomData data = measure({BoomPlant::simple, no_noise, -0.025}, 1);
    auto identified = identify_boom(data, model_of(data, AreasFrom::spool), rising, 1);
    REQUIRE(identified.least_squares);
    CHECK(*identified.least_squares < -0.001);
    CHECK(identified.compliance_in3_per_psi == 0);
    CHECK(identified.at_lower_bound);
}
