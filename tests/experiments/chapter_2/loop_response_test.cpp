// Tests the step response of the P-D loop by partial fractions, and the circuits' searches by the thesis.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

const Replay& replay_of_loop() {
    static const Replay replay = test::replay_named("figures-2-8-2-9");
    return replay;
}

/// Returns the figure in the column of this multiple of C, in the table of the loop with a_1 and a_2 exchanged.
double of_loop(const std::string& row, const std::string& multiple) {
    for (const Cell& cell : replay_of_loop().comparisons.at(0).cells)
        if (cell.row == row && cell.column == multiple)
            return cell.simulated;
    FAIL("no cell of " << row << ", " << multiple);
    return 0;
}

/// Returns the response to a unit step, at one time, of a loop with these three poles and without zeros, by partial
/// fractions: 1 + sum of r_i exp(p_i t), where r_i = -p_1 p_2 p_3 / (p_i prod (p_i - p_j)).
double step_by_poles(const std::array<std::complex<double>, 3>& poles, double time_s) {
    const std::complex<double> gain = -poles[0] * poles[1] * poles[2];
    std::complex<double> response = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        std::complex<double> residue = gain / poles[i];
        for (std::size_t j = 0; j < 3; ++j)
            if (j != i)
                residue /= poles[i] - poles[j];
        response += residue * std::exp(poles[i] * time_s);
    }
    return response.real();
}

std::array<std::complex<double>, 3> poles_at(const std::string& multiple) {
    const std::complex<double> upper{of_loop("pair of poles, real", multiple), of_loop("pair, imaginary", multiple)};
    return {of_loop("real pole", multiple), upper, std::conj(upper)};
}

const Plot& plot_of_loop(const std::string& name) {
    for (const NamedPlot& each : replay_of_loop().plots)
        if (each.name == name)
            return each.plot;
    FAIL("no plot " << name);
    return replay_of_loop().plots.front().plot;
}

} // namespace

TEST_CASE("Figures 2.8 and 2.9 are the step responses that follow from the poles by partial fractions") {
    const Plot& plot = plot_of_loop("figures-2-8-2-9");
    for (const auto& [panel, multiple] : {std::pair{0, "C"}, std::pair{1, "4 C"}}) {
        const std::vector<Point>& points = plot.panels.at(static_cast<std::size_t>(panel)).series.at(0).points;
        CHECK(points.front().y == 0);
        CHECK(points.back().x == doctest::Approx(4));
        for (const Point& point : points)
            CHECK(std::abs(point.y - step_by_poles(poles_at(multiple), point.x)) < 1e-9);
    }
}

TEST_CASE("overshoot, its time and the settling time are those of the response by partial fractions") {
    for (const char* multiple : {"C", "2 C", "4 C"}) {
        CAPTURE(std::string(multiple));
        const auto poles = poles_at(multiple);
        double peak = 0, peak_s = 0, unsettled_s = 0;
        for (int ms = 0; ms < 20000; ++ms) {
            const double time_s = 0.001 * ms, response = step_by_poles(poles, time_s);
            if (response > peak) {
                peak = response;
                peak_s = time_s;
            }
            if (std::abs(response - 1) > 0.02)
                unsettled_s = time_s;
        }
        CHECK(of_loop("overshoot", multiple) == doctest::Approx(100 * (peak - 1)).epsilon(1e-6));
        CHECK(std::abs(of_loop("  its time", multiple) - peak_s) < 0.0011);
        CHECK(std::abs(of_loop("settled within 2 %", multiple) - unsettled_s) < 0.0021);
    }
}

TEST_CASE("a loop that does not settle has no overshoot, and its pair of poles is not left of the imaginary axis") {
    for (const char* multiple : {"6 C", "7 C"}) {
        CHECK(of_loop("pair of poles, real", multiple) > -1e-9);
        for (const Cell& cell : test::row_named(replay_of_loop().comparisons.at(0), "overshoot"))
            CHECK(cell.column != multiple);
    }
}

TEST_CASE("the loci end where the poles of half and of ten times C are, and the pair is symmetric") {
    const Panel& panel = plot_of_loop("pole-loci").panels.at(0);
    REQUIRE(panel.series.size() == 3 + 5 + 1); // three poles, five multiples of C, and the limit of stability
    const std::vector<Point>&lower = panel.series[1].points, &upper = panel.series[2].points;
    REQUIRE(lower.size() == upper.size());
    for (std::size_t i = 0; i < lower.size(); ++i) {
        CHECK(lower[i].x == doctest::Approx(upper[i].x));
        CHECK(lower[i].y == doctest::Approx(-upper[i].y));
    }
    for (std::size_t i = 3; i < 8; ++i)
        CHECK(panel.series[i].points.size() == 3);
    CHECK(lower.back().x > 0); // beyond the limit of stability at 6 C
    CHECK(lower.front().x < 0);
}

TEST_CASE("equation 2.9 as printed has a margin of 15.3, so even seven times C would be stable") {
    const Comparison& printed = replay_of_loop().comparisons.at(1);
    CHECK(printed.judged);
    const auto margins = test::row_named(printed, "stability margin");
    REQUIRE(margins.size() == 5);
    CHECK(margins[0].simulated == doctest::Approx(46.0 / 3).epsilon(1e-4));
    for (const Cell& margin : margins)
        CHECK(margin.simulated > 1);
    CHECK(test::row_named(printed, "overshoot").size() == 5);
}

TEST_CASE("the thesis's two searches in a and b, and one in d and e; c has two, too") {
    const Replay circuits = test::replay_named("circuits");
    const auto searches = test::row_named(circuits.comparisons.at(0), "searches"),
               links = test::row_named(circuits.comparisons[0], "links of the greatest");
    REQUIRE(searches.size() == 5);
    REQUIRE(links.size() == 5);
    const std::vector<double> known_searches{2, 2, 2, 1, 1}, known_links{2, 3, 3, 4, 4};
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(searches[i].simulated == known_searches[i]);
        CHECK(links[i].simulated == known_links[i]);
        CHECK(searches[i].is_judged() == (i != 2)); // the thesis does not say it of c
    }
    CHECK(test::row_named(circuits.comparisons.at(1), "Q_BUi, Q_BOi, Q_11, Q_12, P_11, P_12").at(0).simulated == 6);
}
