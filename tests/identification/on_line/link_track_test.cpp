#include "identification/on_line/link_track.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

TEST_CASE("the spool is computed from its voltage") {
    LinkTrack by_voltage, by_spool;
    LinkConstants parameters{716.8, 8};
    // By A.2, after a voltage step the spool stays for one sample; then its distance shrinks by exp(-8 * .02) per
    // sample.
    double spool = 0.1297, desired = 0.0892 * 0.027 + 0.2352 * 0.09 + 0.2815 * 0.3 + 0.1297;
    for (int k = 0; k < 8; ++k) {
        by_voltage.read({1500, 0, ServoVoltage{k < 2 ? 0 : 0.3}}, parameters, 0.020);
        if (k > 2)
            spool = desired + (spool - desired) * 0.852143788966211;
        by_spool.read({1500, 0, SpoolPosition{spool}}, parameters, 0.020);
        by_voltage.finish_sample();
        by_spool.finish_sample();
    }
    REQUIRE(by_voltage.state().inlet_in2.size() == 5);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(by_voltage.state().bypass_in2[i] == test::nearly(by_spool.state().bypass_in2[i], 1e-9));
}
