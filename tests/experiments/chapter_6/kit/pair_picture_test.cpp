#include "experiments/chapter_6/kit/pair_picture.hpp"
#include "experiments/chapter_6/kit/plant_runs.hpp"

#include <doctest/doctest.h>

#include <string_view>

using namespace placedpar;

namespace {

CoarseFineSettings pair_of(std::size_t field_bits) {
    Recoding coarse = plant_reading(field_bits);
    return {plant_settings(24), plant_settings(30), coarse, coarse.bits};
}

std::string drawn(std::size_t field_bits) {
    return draw_pair(pair_of(field_bits), plant_search_problem().parameter_names());
}

std::size_t occurrences(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

} // namespace

TEST_CASE("the drawing has each search's strings, and each of their bits") {
    std::string svg = drawn(4);
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(occurrences(svg, "24 strings of 22 bits") == 1);
    CHECK(occurrences(svg, "30 strings of 22 bits") == 1);
    CHECK(occurrences(svg, "newest 30 samples") == 1);
    CHECK(occurrences(svg, "\"bit coarse\"") == 2 * 22); // in its own string, and their places in the problem's
    CHECK(occurrences(svg, "\"bit zero\"") == 37 - 22);  // the bits that the coarse string leaves out
    CHECK(occurrences(svg, "\"bit fine\"") == 22);
    CHECK(occurrences(svg, "−8 ... +7") == 5);
    CHECK(occurrences(svg, ">all<") == 1); // the delay has all its bits in both strings
}

TEST_CASE("the drawing follows the settings") {
    CHECK(occurrences(drawn(5), "\"bit zero\"") == 37 - 27);
    CHECK(occurrences(drawn(5), "−16 ... +15") == 5);
    CHECK(drawn(5) == drawn(5));
}
