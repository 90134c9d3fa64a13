// Tests the tables of chapter 6 about the hypercube, by the thesis's formulas and by counts with other means.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the replay, which is made once for all tests of this file.
const Replay& hypercube_replay() {
    static const Replay replay = test::replay_named("hypercube");
    return replay;
}

const Cell& vertex_cell(std::size_t table, const std::string& row, const std::string& column) {
    for (const Cell& cell : hypercube_replay().comparisons.at(table).cells)
        if (cell.row == row && cell.column == column)
            return cell;
    FAIL("no cell of " << row << ", " << column);
    return hypercube_replay().comparisons.front().cells.front();
}

double neighbours_at(int differ, const std::string& dimension) {
    const std::string row =
        "neighbours at " + std::to_string(differ) + (differ == 1 ? " bit" : " bits") + " of difference";
    return vertex_cell(0, row, dimension).simulated;
}

std::string pair_row(int differ) { return "parents that differ in " + std::to_string(differ); }

/// Returns how many strings, other than the parents, one cut, two cuts or any choice of bits can make of 0...0 and of
/// 1...1, which differ in all of these bits.
std::size_t offspring_of_opposites(int bits, int cuts) {
    const std::uint32_t all = (1u << bits) - 1;
    std::set<std::uint32_t> made;
    for (std::uint32_t mask = 1; mask < all; ++mask) {
        int changes = 0; // places at which neighbouring bits come from different parents
        for (int bit = 1; bit < bits; ++bit)
            changes += ((mask >> bit) & 1) != ((mask >> (bit - 1)) & 1);
        if (changes <= cuts)
            made.insert({mask, all ^ mask});
    }
    return made.size();
}

std::size_t count_in_drawing(const std::string& svg, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = svg.find(part); at != svg.npos; at = svg.find(part, at + 1))
        ++count;
    return count;
}

const std::string& drawing_named(const std::string& name) {
    for (const NamedDrawing& each : hypercube_replay().drawings)
        if (each.name == name)
            return each.svg;
    FAIL("no drawing " << name);
    return hypercube_replay().drawings.front().svg;
}

} // namespace

TEST_CASE("Table 6.1: l neighbours at one bit, l! / (2! (l - 2)!) at two, l at l - 1, and one at l") {
    for (int l : {4, 8}) {
        const std::string dimension = "l = " + std::to_string(l);
        CHECK(neighbours_at(1, dimension) == l);
        CHECK(neighbours_at(2, dimension) == l * (l - 1) / 2);
        CHECK(neighbours_at(l - 1, dimension) == l);
        CHECK(neighbours_at(l, dimension) == 1);
        double all = 0;
        for (int differ = 0; differ <= l; ++differ)
            all += neighbours_at(differ, dimension);
        CHECK(all == std::exp2(l)); // with the vertex itself
    }
    CHECK(neighbours_at(4, "l = 8") == 70);
}

TEST_CASE("the thesis prints no neighbour at no difference; the vertex itself is counted, and not judged") {
    const Cell& itself = vertex_cell(0, "neighbours at 0 bits of difference", "l = 8");
    CHECK(itself.simulated == 1);
    CHECK(itself.reference == 0.0);
    CHECK_FALSE(itself.is_judged());
    CHECK(vertex_cell(0, "neighbours at 1 bit of difference", "l = 8").is_judged());
}

TEST_CASE("Table 6.2: offspring stay between their parents, keep their difference, and are near one of them") {
    for (int differ = 1; differ <= 7; ++differ) {
        CAPTURE(differ);
        CHECK(vertex_cell(1, pair_row(differ), "outside of the space").simulated == 0);
        CHECK(vertex_cell(1, pair_row(differ), "another difference").simulated == 0);
        CHECK(vertex_cell(1, pair_row(differ), "most from nearer parent").simulated == differ / 2);
        // A cut before all different bits changes all of them; of seven such bits, the own parent keeps the first.
        CHECK(vertex_cell(1, pair_row(differ), "most from own parent").simulated == std::min(differ, 6));
    }
}

TEST_CASE("one cut reaches 2 (n - 1) new vertices, two cuts n (n - 1), and uniform crossover all 2^n - 2") {
    for (int differ = 1; differ <= 7; ++differ) {
        CAPTURE(differ);
        const auto reached = [&](const char* crossover) {
            return static_cast<std::size_t>(vertex_cell(2, pair_row(differ), crossover).simulated);
        };
        CHECK(reached("one-point") == offspring_of_opposites(differ, 1));
        CHECK(reached("by-difference") == offspring_of_opposites(differ, 1));
        CHECK(reached("two-point") == offspring_of_opposites(differ, 2));
        CHECK(reached("uniform") == offspring_of_opposites(differ, differ));
    }
    CHECK(vertex_cell(2, pair_row(1), "uniform").simulated == 0); // "no new location" in Table 6.2
}

TEST_CASE("each crossover of all pairs agrees with its formula, so the replay is within its tolerances") {
    CHECK(hypercube_replay().within_tolerance());
    for (const Cell& cell : hypercube_replay().comparisons.at(2).cells) {
        CHECK(cell.is_judged());
        CHECK(cell.reference == cell.simulated);
    }
}

TEST_CASE("Figure 6.3 draws 2 + 4 + 8 + 16 vertices, and of two bits both new ones") {
    const std::string& svg = drawing_named("figure-6-3");
    for (const char* line : {"on a link (2 vertices):", "on a plane (4 vertices):", "on a cube (8 vertices):",
                             "on a hypercube of dimension 4 (16 vertices):"})
        CHECK(count_in_drawing(svg, line) == 1);
    for (const char* line : {">0 new of 0<", ">2 new of 2<", ">4 new of 6<", ">6 new of 14<"})
        CHECK(count_in_drawing(svg, line) == 1);
}

TEST_CASE("Figure 6.1: more numbers are maxima among two neighbours on the line than among four on the hypercube") {
    const std::vector<int> values{0, 1, 2, 3, 4, 5, 9, 6, 2, 8, 3, 7, 1, 10, 5, 4}; // as drawn
    std::size_t on_line = 0, on_cube = 0;
    for (std::size_t x = 0; x < 16; ++x) {
        on_line += (x == 0 || values[x - 1] < values[x]) && (x == 15 || values[x + 1] < values[x]);
        bool greatest = true;
        for (std::size_t bit : {1u, 2u, 4u, 8u})
            greatest = greatest && values[x ^ bit] < values[x];
        on_cube += greatest;
    }
    CHECK(on_line == 4);
    CHECK(on_cube < on_line);
    const Plot& line = hypercube_replay().plots.at(0).plot;
    CHECK(line.panels.at(0).series.at(1).points.size() == on_line);
    CHECK(count_in_drawing(drawing_named("figure-6-1"), "On the line " + std::to_string(on_line) +
                                                            " of 16 numbers are maxima, on the hypercube " +
                                                            std::to_string(on_cube) + ".") == 1);
}

TEST_CASE("Figure 6.5: an impulse is flat on the hypercube too, and the share of right bits is a slope") {
    const Plot& plot = hypercube_replay().plots.at(1).plot;
    const std::vector<Point>&impulse = plot.panels.at(1).series.at(0).points,
          &slope = plot.panels[1].series.at(1).points;
    REQUIRE(impulse.size() == 5);
    CHECK(impulse[0].y == 1);
    for (std::size_t differ = 1; differ <= 4; ++differ) {
        CHECK(impulse[differ].y == 0);
        CHECK(slope.at(differ).y == slope[differ - 1].y - 0.25);
    }
}
