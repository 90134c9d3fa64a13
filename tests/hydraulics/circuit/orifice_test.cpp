#include "hydraulics/circuit/orifice.hpp"
#include "runtime/lanes.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace placedpar;

TEST_CASE("eight orifice flows computed together equal separate flows, to the bit") {
    const std::array<double, 8> drops{-1, 0, 1e-300, 0.3, 2, 3, 1700, 4500};
    auto flows = hydraulics::orifice_flow(7.3, Lanes<2>(drops)).numbers();
    for (std::size_t i = 0; i < drops.size(); ++i) {
        CAPTURE(drops[i]);
        CHECK(flows[i] == hydraulics::orifice_flow(7.3, drops[i]));
        CHECK(flows[i] == 7.3 * std::sqrt(drops[i] > 0 ? drops[i] : 0.0));
    }
}
