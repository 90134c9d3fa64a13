#include "hydraulics/circuit/voltage_spool.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

TEST_CASE("A.1 and its inverse agree at the thesis's knees and spools") {
    struct Pair {
        double spool_in, volts;
    };
    constexpr Pair pairs[] = {{0.188, 0.1786}, {0.2007, 0.2117}, {0.2427, 0.3110}, {0.2650, 0.3586}, {0.2741, 0.3771},
                              {0.376, 0.5588}, {0.5, 0.7362},    {0.1297, 0},      {0.7356, 1}};
    for (const Pair& pair : pairs) {
        double spool_in = pair.spool_in, volts = pair.volts;
        CAPTURE(spool_in);
        CHECK(std::abs(servo_volts(spool_in) - volts) < 1e-4);
        CHECK(std::abs(desired_spool_in(volts) - spool_in) < 1e-4);
    }
    CHECK(std::abs(servo_volts(0) + 0.9244) < 1e-4);
    CHECK(desired_spool_in(0) == 0.1297);
}

TEST_CASE("A.1 rises everywhere, least steeply at -.879 V, and servo_volts() is its inverse") {
    double before = desired_spool_in(-3);
    for (int i = -2999; i <= 3000; ++i) {
        double volts = i * 1e-3, spool = desired_spool_in(volts);
        CHECK(spool - before > 0.0747e-3); // the least slope is .0748 in/V
        before = spool;
        if (spool >= 0)
            CHECK(std::abs(servo_volts(spool) - volts) < 1e-13);
    }
    CHECK(std::abs(servo_volts(50) - 7.4) < 0.5); // far outside the table
    CHECK(std::abs(desired_spool_in(servo_volts(50)) - 50) < 1e-10);
}

TEST_CASE("0.01 in of spool correspond to 20 to 22 mV in the working range") {
    for (double spool = 0.2427; spool < 0.2741; spool += 0.001) {
        double volts = servo_volts(spool + 0.005) - servo_volts(spool - 0.005);
        CHECK(volts > 0.0199);
        CHECK(volts < 0.0221);
    }
}

TEST_CASE("a spool below 0 has no voltage") {
    CHECK_THROWS_WITH_AS(servo_volts(-0.01), "no voltage moves the spool to -0.01 in, expected 0 or more",
                         std::invalid_argument);
    CHECK_THROWS_AS(servo_volts(NAN), std::invalid_argument);
}

TEST_CASE("the spool lag is exact for held commands") {
    SpoolLag lag(8, 0.02, 0.1297);
    for (int k = 0; k <= 50; ++k) {
        CHECK(lag.spool_in() == doctest::Approx(0.1297 + 0.1296 * (1 - std::exp(-8 * 0.02 * k))).epsilon(1e-12));
        lag.hold(0.2593);
    }
    CHECK_THROWS_AS(SpoolLag(0, 0.02, 0), std::invalid_argument);
    CHECK_THROWS_AS(SpoolLag(8, -1, 0), std::invalid_argument);
}

TEST_CASE("the spool responds to a voltage step one period later") {
    std::vector<double> volts{0, 0, 0.35, 0.35, 0.35};
    auto spools = spool_from_volts(volts, 8, 0.02);
    REQUIRE(spools.size() == 5);
    double rest = 0.1297, asked = desired_spool_in(0.35), kept = std::exp(-0.16);
    CHECK(spools[0] == rest);
    CHECK(spools[1] == doctest::Approx(rest).epsilon(1e-15));
    CHECK(spools[2] == doctest::Approx(rest).epsilon(1e-15)); // Desired(k-1), not Desired(k)
    CHECK(spools[3] == doctest::Approx(asked + (rest - asked) * kept));
    CHECK(spools[4] == doctest::Approx(asked + (rest - asked) * kept * kept));
    CHECK(spool_from_volts({}, 8, 0.02).empty());
}

TEST_CASE("over a gap the spool follows the last command") {
    std::vector<double> volts{0, 0.35, 0.35, 0.35, 0.2, 0.2}, time_s{0, 0.02, 0.04, 0.06, 0.08, 0.1};
    auto whole = spool_from_volts(volts, 8, 0.02);
    auto at = [&](std::vector<std::size_t> rows) {
        std::vector<double> some_volts, some_times;
        for (std::size_t row : rows) {
            some_volts.push_back(volts[row]);
            some_times.push_back(time_s[row]);
        }
        return spool_from_volts(some_volts, some_times, 8, 0.02);
    };
    CHECK(at({0, 1, 2, 3, 4, 5}) == whole); // equal to the bit
    auto gap = at({0, 1, 4, 5});
    CHECK(gap[2] == doctest::Approx(whole[4]).epsilon(1e-14));
    CHECK(gap[3] == doctest::Approx(whole[5]).epsilon(1e-14));
    CHECK(spool_from_volts(std::vector<double>{0, 0.35, 0.35}, std::vector<double>{0, 0.02, 1e9}, 8, 0.02)[2] ==
          desired_spool_in(0.35)); // a gap of years takes no more time
}

TEST_CASE("a drift adds growing offsets to voltage and spool") {
    DriftedVoltageSpool spool_off{{}, {0.01, 0}};
    CHECK(spool_off.desired_spool_in(0.35, 100) == doctest::Approx(desired_spool_in(0.35) + 0.01));
    DriftedVoltageSpool volts_off{{0.02, 0.001}, {}};
    CHECK(volts_off.desired_spool_in(0.3, 30) == doctest::Approx(desired_spool_in(0.35)));
    CHECK(DriftedVoltageSpool{{}, {-0.2, 0}}.desired_spool_in(0, 0) == 0); // the end of the spool's travel

    std::vector<double> volts(200, 0.3);
    auto exact = spool_from_volts(volts, 8, 0.02), drifting = spool_from_volts(volts, 8, 0.02, {{}, {0, 0.01}});
    // In a ramp of .01 in/s the lag delays the spool by .01 / 8 in, plus half a period for the held command.
    double ramp = drifting.back() - exact.back();
    CHECK(std::abs(ramp - 0.01 * (199 * 0.02 - 1 / 8.0 - 0.01)) < 2e-5);
}
