#include "hydraulics/data/clock_time.hpp"

#include <doctest/doctest.h>

using namespace placedpar::hydraulics;

namespace {

constexpr std::int64_t second_ns = 1'000'000'000, hour_ns = 3600 * second_ns;

std::int64_t ns_of(std::string_view text) {
    const auto time = clock_time(text);
    REQUIRE_MESSAGE(time, text);
    return time->since_1970_ns;
}

} // namespace

TEST_CASE("dates and times of ISO 8601 are read") {
    const std::int64_t half_past_two_ns = 1709649000 * second_ns; // by date -ud "2024-03-05 14:30" +%s
    for (const char* text : {"2024-03-05T14:30", "2024-03-05 14:30:00", "2024-03-05t14:30:00.000", "20240305T143000Z",
                             "20240305T1430", "2024-03-05T14:30:00,000+00:00", "2024-03-05 14:30:00 Z"})
        CHECK(ns_of(text) == half_past_two_ns);
    CHECK(ns_of("2024-03-05T14:30:00.02") == half_past_two_ns + 20'000'000);
    CHECK(ns_of("2024-03-05T14:30:00.0000000019") == half_past_two_ns + 1);
    CHECK(ns_of("2024-03-05T15:30:00+01:00") == half_past_two_ns);
    CHECK(ns_of("2024-03-05T10:00:00-0430") == half_past_two_ns);
    CHECK(ns_of("2024-03-05T16:30+02") == half_past_two_ns);
    CHECK(ns_of("2024-02-29T00:00:00") == ns_of("2024-02-28T00:00:00") + 24 * hour_ns);
    CHECK(ns_of("1969-12-31T23:59:59Z") == -second_ns);
    // By date -ud. The difference of any two dates fits 64 bits of ns.
    CHECK(ns_of("1900-01-01T00:00-2359") == -2208988800 * second_ns + 23 * hour_ns + 59 * 60 * second_ns);
    CHECK(ns_of("2100-12-31T23:59:59") == 4133980799 * second_ns);
    CHECK(ns_of("2100-12-31T23:59:59") - ns_of("1900-01-01T00:00") == 6342969599 * second_ns);
    CHECK(clock_time("2024-03-05T14:30Z")->has_zone);
    CHECK(!clock_time("2024-03-05T14:30")->has_zone);
}

TEST_CASE("other texts are not dates and times of ISO 8601") {
    for (const char* text : {"",
                             "0.02",
                             "2024",
                             "2024-03-05",
                             "2024-3-5T14:30",
                             "2024-13-05T14:30",
                             "2023-02-29T00:00",
                             "2024-0305T14:30",
                             "2024-03-05T24:00",
                             "2024-03-05T14:60",
                             "2024-03-05T14:30:",
                             "2024-03-05T14:30:61",
                             "2024-03-05T14:30:00.",
                             "2024-03-05T14:30:00.0x",
                             "2024-03-05T14:30Z1",
                             "2024-03-05T14:30+",
                             "2024-03-05T14:30+1",
                             "1899-12-31T23:59",
                             "2101-01-01T00:00",
                             "05.03.2024 14:30:00",
                             "2024-03-05X14:30",
                             "99999-03-05T14:30",
                             "2024-03-05T14:30:00 +01:00 x"})
        CHECK_MESSAGE(!clock_time(text), text);
}

TEST_CASE("a date is found in a file's name, and printed") {
    CHECK(date_in_name("boom.csv") == std::nullopt);
    CHECK(date_in_name("boom-10000001.csv") == std::nullopt);
    CHECK(date_in_name("boom-2024-03-05.csv") == 1709596800);
    CHECK(date_in_name("20240305_1430.csv") == 1709649000);
    CHECK(date_in_name("PC200_20240305-143000_left.csv") == 1709649000);
    CHECK(date_in_name("2024-03-05T14-30-00.csv") == 1709649000);
    CHECK(date_in_name("2024-03-05_14-30.csv") == 1709649000);
    CHECK(date_text(1709649000) == "2024-03-05 14:30");
    CHECK(date_text(1709596800) == "2024-03-05");
    CHECK(date_text(-1) == "1969-12-31 23:59");
}
