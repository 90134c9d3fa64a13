#include "gaprocs/window.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>

using namespace placedpar;

namespace {

WindowSettings window_of(std::size_t length, std::size_t first) {
    WindowSettings settings;
    settings.length = length;
    settings.first = first;
    return settings;
}

} // namespace

TEST_CASE("the window holds the last samples, oldest first, and is ready from the fifth sample on") {
    SlidingWindow window{WindowSettings{}};
    for (std::size_t k = 0; k < 25; ++k) {
        window.push({double(k), -1});
        std::size_t expected = std::min<std::size_t>(k + 1, 10);
        REQUIRE(window.samples().size() == expected);
        CHECK(window.ready() == (k >= 4));
        for (std::size_t i = 0; i < expected; ++i)
            CHECK(window.samples()[i] == Sample{double(k) + 1 - double(expected) + double(i), -1});
    }
    window.clear();
    CHECK_FALSE(window.ready());
    CHECK(window.samples().empty());
}

TEST_CASE("a window shorter than the number of samples before the first generation is ready when it is full") {
    SlidingWindow window(window_of(2, 5));
    window.push({1});
    CHECK_FALSE(window.ready());
    window.push({2});
    CHECK(window.ready());
}

TEST_CASE("windows that make no sense are refused with a reason") {
    auto message = [](WindowSettings settings, const char* expected) {
        CHECK_THROWS_WITH_AS(settings.validate_for(20), expected, UserError);
    };
    message(window_of(0, 5), "the window holds 0 samples, expected at least 1");
    message(window_of(1025, 5), "the window holds 1025 samples, expected at most 1024");
    message(window_of(10, 0), "the first generation waits for 0 samples, expected at least 1");
    message(window_of(21, 5), "the window holds 21 samples, but the record has only 20");
    WindowSettings settings;
    settings.trials = 0;
    message(settings, "the number of generations per sample is 0, expected at least 1");
    settings = {};
    settings.bias = 0;
    message(settings, "the fitness bias is 0, expected a number above 0 and at most 8388608");
    CHECK_NOTHROW(window_of(20, 5).validate_for(20));
}
