// Tests the price of a machine.

#include "explore/study/price.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/read.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("a machine's price is the sum of its parts; a part without a price costs nothing") {
    const ReadResult read = read_netlist_text("workstation sun; T800 a, b; T414 c; connect sun.link[0] to a.link[0];"
                                              "connect a.link[1] to b.link[0]; connect b.link[1] to c.link[0];",
                                              Catalogue());
    INFO(render(read));
    REQUIRE(read.network);
    CHECK(price_of(*read.network, {}) == 0);
    CHECK(price_of(*read.network, {{"T800", 300}}) == 600);
    CHECK(price_of(*read.network, {{"T800", 300}, {"T414", 120.5}, {"link", 20}}) == 780.5); // 600 + 120.5 + 3 * 20
}

TEST_CASE("a price of an unknown part is refused with the part that may be meant") {
    CHECK_NOTHROW(require_parts({{"T800", 1}, {"C004", 1}, {"link", 1}}, Catalogue()));
    CHECK_THROWS_WITH_AS(require_parts({{"T80O", 1}}, Catalogue()),
                         doctest::Contains("unknown part with a price \"T80O\"; did you mean \"T800\"?"), UserError);
}
