// Tests the lengths of cycles, to the picosecond.

#include "runtime/time.hpp"

#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

using namespace placedpar;

TEST_CASE("a Clock gives the lengths that a division of 128 bits gives") {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    RandomStream random(1, "clocks");
    for (std::int64_t hertz : {1l, 3l, 7'000'000l, 17'500'000l, 20'000'000l, 22'500'000l, 30'000'000l, 999'999'999'989l,
                               1'000'000'000'001l, most}) {
        CAPTURE(hertz);
        Clock clock(hertz);
        CHECK(clock.hertz() == hertz);
        for (std::int64_t cycles : {0l, 1l, 2l, 19l, 1'000'003l, most / 2, most - 1, most})
            CHECK(clock.duration(cycles) == duration_of(cycles, hertz));
        for (int bits = 1; bits < 63; ++bits) {
            auto cycles = (std::int64_t{1} << bits) + static_cast<std::int64_t>(random.below(1u << std::min(bits, 31)));
            CHECK(clock.duration(cycles) == duration_of(cycles, hertz));
        }
    }
}
