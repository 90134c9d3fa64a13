#include "netlist/network/names.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("names are split into base and subscripts") {
    CHECK(base_name("out[2]") == "out");
    CHECK(base_name("t[0][1]") == "t");
    CHECK(base_name("root") == "root");
    CHECK(subscripts_of("t[0][12]") == std::vector<std::int64_t>{0, 12});
    CHECK(subscripts_of("root").empty());
    CHECK(element_name("t", {0, 12}) == "t[0][12]");
    CHECK(element_name("root", {}) == "root");
}

TEST_CASE("the last subscript varies fastest") {
    CHECK(element_count({}) == 1);
    CHECK(element_count({2, 3}) == 6);
    CHECK(element_subscripts(0, {2, 3}) == std::vector<std::int64_t>{0, 0});
    CHECK(element_subscripts(4, {2, 3}) == std::vector<std::int64_t>{1, 1});
    CHECK(element_subscripts(5, {2, 3}) == std::vector<std::int64_t>{1, 2});
}
