// Tests chapter 2 (steady flow, oil with air in it, and the P-D loop) against the thesis and formulas worked out by
// hand.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the modulus of oil of 220 000 psi that contains this share of free air at 14.7 psia. The air is compressed
/// at constant temperature. The modulus is the volume divided by its decrease for one psi.
double isothermal_modulus_psi(double air, double psia) {
    const double air_volume = air * 14.7 / psia;
    return (1 - air + air_volume) / ((1 - air) / 220'000 + air_volume / psia);
}

} // namespace

TEST_CASE("Table 2.6: the spool for three flows at three pressures, and back") {
    const Replay replay = test::replay_named("table-2-6");
    const Comparison& table = replay.comparisons.at(0);
    struct Line {
        int flow;
        std::vector<double> spool_in; // at 2030, 1830 and 1630 psi
    };
    for (const Line& line :
         {Line{60, {0.2741, 0.2688, 0.2627}}, Line{50, {0.2650, 0.2592, 0.2527}}, Line{40, {0.2561, 0.2499, 0.2427}}}) {
        const auto spools = test::row_named(table, fmt::format("spool at {} in^3/s", line.flow)),
                   flows = test::row_named(table, fmt::format("flow at {} in^3/s", line.flow));
        REQUIRE(spools.size() == 3);
        REQUIRE(flows.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(std::abs(spools[i].simulated - line.spool_in[i]) < 2e-4);
            CHECK(spools[i].reference == line.spool_in[i]);
            CHECK(std::abs(flows[i].simulated - line.flow) < 0.15);
        }
    }
}

TEST_CASE("an error of the spool raises the flow by a half or a fifth, as in the thesis, and more at smaller flows") {
    const Replay replay = test::replay_named("table-2-6");
    const Comparison& table = replay.comparisons.at(0);
    for (const char* error : {"more flow for +0.02 in", "more flow for +0.01 in"})
        for (std::size_t i = 0; i < 3; ++i) {
            auto at = [&](int flow) {
                return test::row_named(table, fmt::format("{} at {} in^3/s", error, flow)).at(i).simulated;
            };
            CHECK(at(40) > at(50));
            CHECK(at(50) > at(60));
            CHECK(at(60) > 0);
        }
    for (int flow : {40, 50, 60}) // a step of .01 in: by the slope, and by the difference of flows
        for (std::size_t i = 0; i < 3; ++i) {
            const double
                slope = test::row_named(table, fmt::format("dQ_i/dx at {} in^3/s", flow)).at(i).simulated,
                more = test::row_named(table, fmt::format("more flow for +0.01 in at {} in^3/s", flow)).at(i).simulated;
            CHECK(more == doctest::Approx(100 * 0.01 * slope / flow).epsilon(0.01));
        }
}

TEST_CASE("the stiffness of oil with air is that of separate volumes of both") {
    const Replay replay = test::replay_named("figure-2-3");
    const Comparison& table = replay.comparisons.at(0);
    for (double percent : {0.1, 1.0, 5.0}) {
        const auto row = test::row_named(table, fmt::format("{:g} % air, isothermal", percent));
        REQUIRE(row.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            const double psia = std::vector{100.0, 500.0, 1000.0, 2000.0}[i];
            CHECK(1000 * row[i].simulated ==
                  doctest::Approx(isothermal_modulus_psi(percent / 100, psia)).epsilon(1e-9));
        }
    }
    for (double percent : {1.0, 2.0, 5.0, 10.0}) { // the compliance is V divided by the modulus
        const auto row = test::row_named(table, fmt::format("C over that of oil, {:g} % air", percent));
        REQUIRE(row.size() == 4);
        CHECK(row[0].simulated == doctest::Approx(220'000 / isothermal_modulus_psi(percent / 100, 100)).epsilon(1e-9));
        for (std::size_t i = 1; i < 4; ++i)
            CHECK(row[i].simulated < row[i - 1].simulated); // the effect of air shrinks with pressure
    }
}

TEST_CASE("at the pressures where C is twice or ten times that of oil, the mixture is a half or a tenth as stiff") {
    const Replay replay = test::replay_named("figure-2-3");
    for (const auto& [row, share] : {std::pair{"pressure where C is twice oil's C", 0.5},
                                     std::pair{"pressure where C is 10 times oil's C", 0.1}}) {
        const auto pressures = test::row_named(replay.comparisons.at(0), row);
        REQUIRE(pressures.size() == 4);
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(isothermal_modulus_psi(std::vector{0.01, 0.02, 0.05, 0.1}[i], pressures[i].simulated) ==
                  doctest::Approx(share * 220'000).epsilon(1e-6));
    }
    const Cell oil = test::row_named(replay.comparisons[0], "oil that alone has C = 0.0086").at(0);
    CHECK(oil.simulated == doctest::Approx(0.0086 * 220'000)); // V = C beta
}

TEST_CASE("the curves of Figure 2.3 rise to the modulus of oil, and that of pure oil is flat") {
    const Replay replay = test::replay_named("figure-2-3");
    const Panel& modulus = replay.plots.at(0).plot.panels.at(0);
    CHECK(modulus.series.at(0).name == "no air");
    for (const Point& point : modulus.series[0].points)
        CHECK(point.y == doctest::Approx(220));
    for (std::size_t i = 1; i < modulus.series.size(); ++i) {
        const std::vector<Point>&curve = modulus.series[i].points, &stiffer = modulus.series[i - 1].points;
        for (std::size_t j = 0; j < curve.size(); ++j) {
            CHECK(curve[j].y <= stiffer[j].y); // more air, less stiff
            CHECK((j == 0 || curve[j].y > curve[j - 1].y));
        }
    }
}

TEST_CASE("the P-D loop: its margin falls as the compliance grows, and at the limit its pair of poles has no damping") {
    const Replay replay = test::replay_named("figures-2-8-2-9");
    const Comparison& loop = replay.comparisons.at(0);
    const auto margin = test::row_named(loop, "stability margin"), damping = test::row_named(loop, "damping zeta"),
               frequency = test::row_named(loop, "natural frequency"), real = test::row_named(loop, "real pole"),
               pair = test::row_named(loop, "pair of poles, real"),
               imaginary = test::row_named(loop, "pair, imaginary");
    REQUIRE(margin.size() == 5); // at 1, 2, 4, 6 and 7 times C
    for (std::size_t i = 0; i < 5; ++i) {
        const double factor = std::vector{1.0, 2.0, 4.0, 6.0, 7.0}[i];
        CHECK(margin[i].simulated == doctest::Approx(6 / factor)); // a margin set by C alone
        CHECK(frequency[i].simulated == doctest::Approx(std::hypot(pair[i].simulated, imaginary[i].simulated)));
        CHECK(damping[i].simulated == doctest::Approx(-pair[i].simulated / frequency[i].simulated));
        // Coefficients of s^3 and s^2: the sum of the poles falls with 1 / C.
        CHECK(real[i].simulated + 2 * pair[i].simulated == doctest::Approx(-30 / factor).epsilon(0.01));
    }
    CHECK(damping[3].simulated == doctest::Approx(0));
    CHECK(test::row_named(loop, "overshoot").size() == 3); // a loop that does not settle has none
}

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

} // namespace

TEST_CASE("the circuits: each configuration has four cylinders, two pumps, and a way out for the oil of each pump") {
    const std::vector<NamedDrawing> drawings = test::replay_named("circuits").drawings;
    REQUIRE(drawings.size() == 4);
    CHECK(drawings[0].name == "figure-2-10");
    CHECK(count(drawings[0].svg, "in b, d") == 1); // the way of branch 2's surplus to the boom
    CHECK(count(drawings[0].svg, "in c, e") == 1); // the way of branch 1's surplus to the stick
    CHECK(drawings[1].name == "figure-2-11");
    CHECK(count(drawings[1].svg, "class=\"cylinder\"") == 5 * 4);
    CHECK(count(drawings[1].svg, "class=\"pump\"") == 5 * 2);
    CHECK(count(drawings[1].svg, ">tank<") == 6); // two in a, one in each other configuration
    CHECK(count(drawings[1].svg, ">shut<") == 2); // the bucket in b, the swing in c
    CHECK(count(drawings[2].svg, "class=\"cylinder\"") == 2);
    CHECK(count(drawings[2].svg, "class=\"pump\"") == 1);
    CHECK(count(drawings[3].svg, "class=\"cylinder\"") == 1);
}
