// Tests the seeds of a study's records: as many as asked for, none shared with another study.
#include "experiments/chapter_3/kit/study.hpp"
#include "experiments/chapter_3/kit/two_link_study.hpp"
#include "experiments/kit/record_seeds.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <set>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

TEST_CASE("studies of 100 seeds have no record in common") {
    std::set<std::uint64_t> all;
    for (std::uint64_t study = 1; study <= 100; ++study)
        for (std::uint64_t seed : record_seeds(study, 50))
            all.insert(seed);
    CHECK(all.size() == 100 * 50);
}

TEST_CASE("more records do not change the first ones") {
    auto few = record_seeds(7, 3), many = record_seeds(7, 200);
    CHECK(few == std::vector<std::uint64_t>(many.begin(), many.begin() + 3));
}

TEST_CASE("a study at the greatest seeds has all its records") {
    constexpr std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
    CHECK(record_seeds(last, 50).size() == 50);
    const std::vector<std::uint64_t> seeds{last, 0};
    CHECK(measure_transients(no_noise, {}, seeds).samples.size() == 2);
    IdentificationWay way = thesis_way();
    way.usable.count = 6;
    CHECK(search_many(simulate_two_links(), no_noise, way, seeds).size() == 2);
}
