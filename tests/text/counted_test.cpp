#include "text/counted.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("one thing is counted in the singular") {
    CHECK(counted(1, "generation") == "1 generation");
    CHECK(counted(0, "generation") == "0 generations");
    CHECK(counted(2, "process", "processes") == "2 processes");
}

TEST_CASE("a plural unit is singular for 1") {
    CHECK(with_unit(1, "individuals") == "1 individual");
    CHECK(with_unit(2, "individuals") == "2 individuals");
    CHECK(with_unit(0.5, "metres") == "0.5 metres");
    CHECK(with_unit(1, "ms") == "1 ms");
    CHECK(with_unit(1, "1/s") == "1 1/s");
    CHECK(with_unit(1, "") == "1");
}
