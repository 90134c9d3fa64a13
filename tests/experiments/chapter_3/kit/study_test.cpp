// Tests the study of many searches on scenario A.

#include "experiments/chapter_3/kit/study.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

TEST_CASE("a study reports the lower median, the 90th percentile and the share within ten percent") {
    SearchStudy study;
    study.error_percent = {20, 1, 4, 2, 3, 12, 7, 5, 9, 40};
    CHECK(study.median_percent() == 5); // not the mean of 5 and 7
    CHECK(study.ninetieth_percent() == 20);
    CHECK(study.within_ten_percent() == 70);
}

TEST_CASE("without noise each search ends near the global optimum, which does not depend on the units") {
    const std::vector<std::uint64_t> seeds{1, 2, 3};
    IdentificationWay way = thesis_way();
    way.coding = Coding::gray;
    way.search.elite = 1;
    const Transients transients = measure_transients(no_noise, way.usable, seeds);
    CHECK(transients.true_in3_per_psi == test::nearly(0.0086));
    REQUIRE(transients.samples.size() == 3);
    CHECK(transients.samples[0].size() == way.usable.count);
    CHECK(transients.samples[0].front().links == transients.samples[2].front().links); // no noise, no difference
    const SearchStudy found = study(transients, way, seeds);
    CHECK(found.within_ten_percent() == 100);
    REQUIRE(found.codes_from_optimum.size() == 3);
    for (double codes : found.codes_from_optimum)
        CHECK(codes <= 8); // of 1024
    for (double codes : found.si_codes)
        CHECK(codes == 0);
}
