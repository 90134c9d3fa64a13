#include "picture/hypercube.hpp"
#include "experiments/kit/experiment.hpp"
#include "gaprocs/policies/crossover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace placedpar {

namespace {

constexpr std::size_t most_counted_bits = 7; ///< dimension of the largest hypercube in which all pairs of vertices are
                                             ///< tried

Genome string_of(std::uint64_t vertex, std::size_t bits) {
    Genome genome(bits);
    genome.set_field(0, bits, vertex);
    return genome;
}

std::size_t bit_difference(std::uint64_t a, std::uint64_t b) { return static_cast<std::size_t>(std::popcount(a ^ b)); }

std::vector<std::size_t> count_neighbours(std::uint64_t vertex, std::size_t bits) {
    std::vector<std::size_t> neighbours(bits + 1);
    for (std::uint64_t other = 0; other < std::uint64_t{1} << bits; ++other)
        ++neighbours[bit_difference(vertex, other)];
    return neighbours;
}

double binomial(std::size_t of, std::size_t chosen) {
    double count = 1;
    for (std::size_t i = 1; i <= chosen; ++i)
        count = count * static_cast<double>(of - chosen + i) / static_cast<double>(i);
    return count;
}

/// Returns a cell with the count. The cell is judged, except for `differ` = 0: the count is then 1, the vertex itself,
/// but the thesis prints 0.
Cell neighbours_cell(std::size_t bits, std::size_t differ, std::size_t counted) {
    std::string row = fmt::format("neighbours at {} bit{} of difference", differ, differ == 1 ? "" : "s"),
                column = fmt::format("l = {}", bits);
    return differ == 0 ? compared_cell(row, column, "", 0, static_cast<double>(counted), 0)
                       : judged_cell(row, column, "", binomial(bits, differ), static_cast<double>(counted), 0, 0);
}

Comparison table_6_1() {
    Comparison comparison{.name = "Table 6.1: vertices of a hypercube of dimension l by their bit difference from one"};
    for (std::size_t bits : {std::size_t{8}, std::size_t{4}}) {
        auto neighbours = count_neighbours(0b0101, bits);
        for (std::size_t differ = 0; differ <= bits; ++differ)
            comparison.add(neighbours_cell(bits, differ, neighbours[differ]));
    }
    comparison.notes = "0 bits of difference: the vertex itself, C(l, 0) = 1; the thesis prints 0\n";
    return comparison;
}

struct Extremes {
    std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;

    void add(std::size_t counted) {
        least = std::min(least, counted);
        most = std::max(most, counted);
    }
};

/// The results of one-point crossover for all pairs of parents with the same number of different bits.
struct Children {
    std::size_t outside = 0;   ///< offspring outside the hypercube spanned by the difference of the parents
    std::size_t otherwise = 0; ///< pairs of offspring that differ in another number of bits than their parents
    std::size_t from_own = 0;  ///< greatest difference of an offspring A1 from A0, the parent of A1's first characters
    std::size_t from_nearer = 0; ///< greatest difference from the nearer parent
};

void add_children(Children& children, const Genome& a, const Genome& b, std::size_t differ) {
    std::uint64_t parent = a.field(0, a.size()), other = b.field(0, b.size());
    for (std::size_t cut = 1; cut < a.size(); ++cut) {
        Genome first = b, second = a; // the first offspring keeps a's characters before the cut (6.5)
        swap_leading(first, second, cut);
        std::uint64_t child = first.field(0, a.size()), sibling = second.field(0, a.size());
        for (std::uint64_t each : {child, sibling})
            children.outside += ((each ^ parent) & ~(parent ^ other)) != 0;
        children.otherwise += bit_difference(child, sibling) != differ;
        children.from_own = std::max(children.from_own, bit_difference(child, parent));
        children.from_nearer =
            std::max(children.from_nearer, std::min(bit_difference(child, parent), bit_difference(child, other)));
    }
}

/// Calls `visit` for every pair of parents on a hypercube, and passes their number of different bits.
template <class Visit>
void for_each_pair(std::size_t bits, Visit visit) {
    for (std::uint64_t a = 0; a < std::uint64_t{1} << bits; ++a)
        for (std::uint64_t b = 0; b < std::uint64_t{1} << bits; ++b)
            visit(string_of(a, bits), string_of(b, bits), bit_difference(a, b));
}

std::string parents_row(std::size_t differ) { return fmt::format("parents that differ in {}", differ); }

Comparison table_6_2() {
    std::vector<Children> children(most_counted_bits + 1);
    for_each_pair(most_counted_bits, [&](const Genome& a, const Genome& b, std::size_t differ) {
        add_children(children[differ], a, b, differ);
    });
    Comparison comparison{.name = fmt::format("Table 6.2: offspring of one-point crossover, all pairs of parents and "
                                              "all cuts, l = {}",
                                              most_counted_bits),
                          .judged = true};
    for (std::size_t differ = 1; differ <= most_counted_bits; ++differ) {
        const Children& found = children[differ];
        auto count = [](std::size_t number) { return static_cast<double>(number); };
        std::string row = parents_row(differ);
        comparison.add(judged_cell(row, "outside of the space", "", 0, count(found.outside), 0, 0));
        comparison.add(judged_cell(row, "another difference", "", 0, count(found.otherwise), 0, 0));
        comparison.add(
            judged_cell(row, "most from nearer parent", "", count(differ / 2), count(found.from_nearer), 0, 0));
        comparison.add(compared_cell(row, "most from own parent", "", count(differ / 2), count(found.from_own), 0));
    }
    comparison.notes = "own parent: A0 for the offspring A1 in equation 6.5. \"0 to integer(n/2) from A0, B0 "
                       "respectively\" holds for the nearer "
                       "parent, not for the own one\n";
    return comparison;
}

std::size_t new_vertices(const Crossover& crossover, const Genome& a, const Genome& b) {
    auto vertices = crossover.every_offspring(a, b);
    vertices.erase(a.field(0, a.size()));
    vertices.erase(b.field(0, b.size()));
    return vertices.size();
}

/// A crossover operator, and the expected number of new vertices that it reaches from parents that differ in n bits.
struct Reach {
    const char* crossover;
    double (*known)(double n);
};

double new_by_one_point(double n) { return 2 * (n - 1); }
double new_by_two_point(double n) { return n == 1 ? 0 : n == 2 ? 2 : n * (n - 1); }
double all_new(double n) { return std::exp2(n) - 2; }

constexpr Reach reaches[]{{"one-point", new_by_one_point},
                          {"by-difference", new_by_one_point},
                          {"two-point", new_by_two_point},
                          {"uniform", all_new}};

/// Adds a row for each number of different bits. The row has the greatest number of new vertices that parents with this
/// difference reach. If the least number is not equal to the greatest, another cell judges it.
void add_reach(Comparison& comparison, const Reach& reach) {
    Crossover crossover = Crossover::named(reach.crossover);
    std::vector<Extremes> counted(most_counted_bits + 1);
    for_each_pair(most_counted_bits, [&](const Genome& a, const Genome& b, std::size_t differ) {
        counted[differ].add(new_vertices(crossover, a, b));
    });
    for (std::size_t differ = 1; differ <= most_counted_bits; ++differ) {
        double known = reach.known(static_cast<double>(differ)), least = static_cast<double>(counted[differ].least),
               most = static_cast<double>(counted[differ].most);
        comparison.add(judged_cell(parents_row(differ), reach.crossover, "", known, most, 0, 0));
        if (least != most)
            comparison.add(judged_cell(parents_row(differ), "least", "", known, least, 0, 0));
    }
}

Comparison reached_vertices(const ReplayContext& context) {
    Comparison comparison{.name = fmt::format("new vertices that crossover can reach between its parents, all pairs, "
                                              "l = {}",
                                              most_counted_bits),
                          .against = "known",
                          .judged = true};
    for (const Reach& reach : reaches) {
        context.progress(fmt::format("{} crossover of all pairs", reach.crossover));
        add_reach(comparison, reach);
    }
    comparison.notes = "known: 2(n - 1) with one cut, n(n - 1) with two, all 2^n - 2 with uniform crossover\n";
    return comparison;
}

std::string draw_figure_6_2() {
    DrawnHypercube cube{.title = "16 vertices, 32 links, 4 neighbours each"};
    cube.vertices = {{.number = 12, .look = VertexLook::parent}, {.number = 5, .look = VertexLook::parent}};
    cube.spanned = {{12, 5}};
    cube.lines = {"From 12 (1100) to 5 (0101) two bits differ: two links, by 4 or by 13."};
    return draw_hypercubes("Figure 6.2: a four-dimensional hypercube", {cube}, 1, {});
}

/// The values of the function in Figure 6.1, for whole numbers from 0 to 15. The function is linear at first; then it
/// has jumps and several maxima.
constexpr std::array figure_6_1_values{0, 1, 2, 3, 4, 5, 9, 6, 2, 8, 3, 7, 1, 10, 5, 4};

/// Returns the numbers at which the function is greater than at all of their neighbours.
template <class Neighbours>
std::vector<std::uint32_t> maxima(Neighbours neighbours_of) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t x = 0; x < figure_6_1_values.size(); ++x)
        if (std::ranges::all_of(neighbours_of(x),
                                [x](std::uint32_t other) { return figure_6_1_values[other] < figure_6_1_values[x]; }))
            found.push_back(x);
    return found;
}

std::vector<std::uint32_t> neighbours_on_the_line(std::uint32_t x) {
    return x == 0                              ? std::vector{x + 1}
           : x + 1 == figure_6_1_values.size() ? std::vector{x - 1}
                                               : std::vector{x - 1, x + 1};
}

std::vector<std::uint32_t> neighbours_on_the_cube(std::uint32_t x) { return {x ^ 1, x ^ 2, x ^ 4, x ^ 8}; }

Plot plot_figure_6_1() {
    auto value_at = [](int x) {
        return Point{static_cast<double>(x), static_cast<double>(figure_6_1_values[static_cast<std::size_t>(x)])};
    };
    Series line = curve({.name = "F(x)"}, static_cast<int>(figure_6_1_values.size()) - 1, value_at);
    Series tops{.name = "maximum among two neighbours", .stroke = Stroke::points};
    for (std::uint32_t x : maxima(neighbours_on_the_line))
        tops.points.push_back(value_at(static_cast<int>(x)));
    return {"Figure 6.1: a function on a line", {{.x = {"x", 0, 15}, .y = {"F(x)", 0, 12}, .series = {line, tops}}}};
}

/// Draws the function of Figure 6.1 and marks its maxima on the hypercube.
std::string draw_figure_6_1() {
    DrawnHypercube cube{.title = "the same 16 numbers, four neighbours each"};
    std::vector<std::uint32_t> tops = maxima(neighbours_on_the_cube);
    for (std::uint32_t x = 0; x < figure_6_1_values.size(); ++x) {
        bool top = std::ranges::find(tops, x) != tops.end();
        cube.vertices.push_back(
            {x, top ? VertexLook::parent : VertexLook::member, fmt::format("F {}", figure_6_1_values[x])});
    }
    cube.lines = {fmt::format("On the line {} of 16 numbers are maxima, on the hypercube {}.",
                              maxima(neighbours_on_the_line).size(), tops.size())};
    return draw_hypercubes("Figure 6.1: a function mapped into a hypercube", {cube}, 1,
                           {{VertexLook::parent, "maximum among its neighbours"}});
}

/// Draws an impulse over x: a fitness that is 1 at 1011 and 0 elsewhere. A second panel shows the fitness over the
/// number of bits that differ from the best string. The second panel also shows the share of right bits, which rises
/// towards the best string.
Plot plot_figure_6_5() {
    auto fitness = [](std::uint32_t x) { return x == 0b1011 ? 1. : 0.; };
    Series impulse = curve({.name = "impulse at 1011"}, 15, [&](int x) {
        return Point{static_cast<double>(x), fitness(static_cast<std::uint32_t>(x))};
    });
    Series flat{.name = "impulse"}, slope{.name = "share of right bits"};
    for (int differ = 0; differ <= 4; ++differ) {
        flat.points.push_back({static_cast<double>(differ), differ == 0 ? 1. : 0.});
        slope.points.push_back({static_cast<double>(differ), 1 - differ / 4.});
    }
    return {"Figure 6.5: an impulse, strings of four bits",
            {{.title = "on the line", .x = {"x", 0, 15}, .y = {"fitness", 0, 1.1}, .series = {impulse}},
             {.title = "on the hypercube",
              .x = {"bits of difference from the best", 0, 4},
              .y = {"fitness", 0, 1.1},
              .series = {flat, slope}}}};
}

/// Draws the offspring of the parents 00...0 and 11...1, which have `differ` bits and differ in all of them.
DrawnHypercube offspring_between_parents(std::size_t differ) {
    constexpr const char* spaces[]{"", "a link", "a plane", "a cube", "a hypercube of dimension 4"};
    Genome first(differ + 1), second = string_of((std::uint64_t{1} << differ) - 1, differ + 1);
    auto last = static_cast<std::uint32_t>((1u << differ) - 1);
    DrawnHypercube cube{
        .title = fmt::format("{} bit{} of difference", differ, differ == 1 ? "" : "s"),
        .dimensions = differ,
        .vertices = {{.number = 0, .look = VertexLook::parent}, {.number = last, .look = VertexLook::parent}}};
    for (std::uint64_t vertex : Crossover().every_offspring(first, second))
        if (vertex != 0 && vertex != last)
            cube.vertices.push_back({.number = static_cast<std::uint32_t>(vertex), .look = VertexLook::offspring});
    cube.lines = {fmt::format("on {} ({} vertices):", spaces[differ], 1u << differ),
                  fmt::format("{} new of {}", cube.vertices.size() - 2, (1u << differ) - 2)};
    return cube;
}

std::string draw_figure_6_3() {
    std::vector<DrawnHypercube> cubes;
    for (std::size_t differ = 1; differ <= 4; ++differ)
        cubes.push_back(offspring_between_parents(differ));
    return draw_hypercubes("Figure 6.3: where the offspring of one-point crossover can be", cubes, 3,
                           {{VertexLook::parent, "parent"},
                            {VertexLook::offspring, "possible offspring"},
                            {VertexLook::empty, "never, by a single cut"}});
}

Replay replay_hypercube(const ReplayContext& context) {
    Replay replay = replay_of({table_6_1(), table_6_2(), reached_vertices(context)},
                              {{"figure-6-1-line", plot_figure_6_1()}, {"figure-6-5", plot_figure_6_5()}});
    replay.drawings = {
        {"figure-6-1", draw_figure_6_1()}, {"figure-6-2", draw_figure_6_2()}, {"figure-6-3", draw_figure_6_3()}};
    return replay;
}

} // namespace

extern const Experiment hypercube_experiment{
    .name = "hypercube",
    .about = "vertices of a hypercube and the vertices that crossover reaches: Tables 6.1, 6.2, Figures 6.2, 6.3",
    .chapter = "6",
    .number = 1,
    .run = replay_hypercube,
};

} // namespace placedpar
