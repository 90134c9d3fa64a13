#include "text/number.hpp"

#include <doctest/doctest.h>

#include <cstdint>

using namespace placedpar;

TEST_CASE("a number must be the whole text") {
    CHECK(parse_number<double>("-2.5e-3") == -2.5e-3);
    CHECK(parse_number<std::uint64_t>("18446744073709551615") == 18446744073709551615u);
    CHECK(parse_number<std::uint64_t>("ff", 16) == 255);
    for (const char* none : {"", " 1", "1 ", "1x", "+1", "0x10", "1,5", "1e400", "-", "--1", "1-2", "\xd9\xa1"}) {
        CAPTURE(none);
        CHECK_FALSE(parse_number<double>(none));
    }
    for (const char* none : {"18446744073709551616", "-1", "1.0", "1e3", "ff"}) {
        CAPTURE(none);
        CHECK_FALSE(parse_number<std::uint64_t>(none));
    }
}
