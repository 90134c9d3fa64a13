// JSON as the program writes it.

#include "report/manifest.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>

using namespace placedpar;

TEST_CASE("numbers read back the same, and those that JSON does not have are null") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    boost::json::array numbers{86.4,   0.1,      -0.0,      1e300,
                               5e-324, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()};
    std::string text = print_pretty(boost::json::object{{"numbers", numbers}});
    CHECK(text.starts_with("{\n  \"numbers\": [\n    86.4,\n    0.1,\n"));
    boost::json::array read = boost::json::parse(text).at("numbers").as_array();
    REQUIRE(read.size() == numbers.size());
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(read[i].to_number<double>() == numbers[i].get_double());
    for (std::size_t i = 5; i < 8; ++i)
        CHECK(read[i].is_null());
}
