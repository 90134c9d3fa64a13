#include "hydraulics/circuit/boom_orifices.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

void check_areas(double spool_in, double bypass_in2, double inlet_in2, double outlet_in2) {
    CAPTURE(spool_in);
    OrificeAreas areas = boom_orifices(spool_in);
    CHECK(areas.bypass_in2 == doctest::Approx(bypass_in2).scale(1).epsilon(1e-5));
    CHECK(areas.inlet_in2 == doctest::Approx(inlet_in2).scale(1).epsilon(1e-5));
    CHECK(areas.outlet_in2 == doctest::Approx(outlet_in2).scale(1).epsilon(1e-5));
}

} // namespace

TEST_CASE("boom orifices at the knees of A.3 to A.9 agree with a hand computation") {
    check_areas(0, 1.5235, 0, 0);
    check_areas(0.188, 0.0477, 0, 0);
    check_areas(0.25, 0.0315, 0.07731, 0.01356); // a_o: -.126 * 1.09 + .1509
    check_areas(0.376, 0, 0.23444, 0.1509);
    check_areas(0.476, 0, 0.2346 + 0.3927, 0.1509 + 0.3927);
}

TEST_CASE("as the spool moves out, the bypass never opens, inlet and outlet never shut, and no area is negative") {
    OrificeAreas before = boom_orifices(0);
    for (int i = 1; i <= 6000; ++i) {
        OrificeAreas areas = boom_orifices(i * 1e-4);
        CAPTURE(i);
        CHECK(areas.bypass_in2 <= before.bypass_in2 + 1e-15);
        CHECK(areas.inlet_in2 >= before.inlet_in2);
        CHECK(areas.outlet_in2 >= before.outlet_in2);
        CHECK(areas.bypass_in2 >= 0);
        before = areas;
    }
}
