#include "explore/time_text.hpp"

#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>

using namespace placedpar;

namespace {

std::int64_t picoseconds_of(const std::string& text) { return parse_time(text).count(); }

} // namespace

TEST_CASE("a time is a number and a unit") {
    CHECK(picoseconds_of("1ps") == 1);
    CHECK(picoseconds_of("1ns") == 1'000);
    CHECK(picoseconds_of("1us") == 1'000'000);
    CHECK(picoseconds_of("1ms") == 1'000'000'000);
    CHECK(picoseconds_of("1s") == 1'000'000'000'000);
    CHECK(picoseconds_of("0") == 0);
    CHECK(picoseconds_of("0.000") == 0);
    CHECK(picoseconds_of("0ms") == 0);
}

TEST_CASE("fractions and powers of ten are exact, where a double would not be") {
    CHECK(picoseconds_of("2.5us") == 2'500'000);
    CHECK(picoseconds_of(".5us") == 500'000);
    CHECK(picoseconds_of("1e3us") == 1'000'000'000);
    CHECK(picoseconds_of("12.5E-2ms") == 125'000'000);
    CHECK(picoseconds_of("1.50000000000000s") == 1'500'000'000'000);      // trailing zeros are ignored
    CHECK(picoseconds_of("9007199254740993ps") == 9'007'199'254'740'993); // 2^53 + 1
    for (std::int64_t each : {1, 3, 7, 999, 1'234'567})
        CHECK(picoseconds_of(fmt::format("{}.{:012}s", each, each)) == each * 1'000'000'000'000 + each);
}

TEST_CASE("the message about a wrong time shows the right form") {
    for (const char* text :
         {"", "5", "ms", "-1", "-ms", "1 ms", "1min", "1.ms", "1e", "1e9999s", "1ms2us", "0x5ms", "+1s"}) {
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(parse_time(text), doctest::Contains("is not a time"), UserError);
    }
}

TEST_CASE("a negative time is refused for its sign") {
    for (const char* text : {"-1us", "-0.5ms", "-1e3ps"})
        CHECK_THROWS_WITH_AS(
            parse_time(text),
            fmt::format("\"{}\" is negative: expected a time of at least 0, such as 2.5ms", text).c_str(), UserError);
}

TEST_CASE("times finer than a picosecond or beyond the end of virtual time are refused") {
    CHECK_THROWS_WITH_AS(parse_time("1.5ps"), doctest::Contains("finer than a picosecond"), UserError);
    CHECK_THROWS_WITH_AS(parse_time("1e-13s"), doctest::Contains("finer than a picosecond"), UserError);
    CHECK_THROWS_WITH_AS(parse_time("1e8s"), doctest::Contains("beyond the end of virtual time"), UserError);
    CHECK_THROWS_WITH_AS(parse_time(std::string(40, '9') + "s"), doctest::Contains("beyond the end"), UserError);
}
