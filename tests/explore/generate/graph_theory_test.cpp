// Compares generated machines with facts of graph theory that their builder does not use: the number of spanning trees,
// the length of the shortest cycle, the bisection width, and whether the processors can be coloured with two colours.

#include "explore/generate/generate.hpp"
#include "explore/generate/topology_request.hpp"
#include "explore/problems.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using generate::TopologyRequest;

namespace {

/// The processors of a machine, numbered from 0, and the wires between them.
struct WiredGraph {
    std::size_t nodes = 0;
    std::vector<std::pair<std::size_t, std::size_t>> wires = {};

    std::vector<std::vector<std::size_t>> neighbours() const {
        std::vector<std::vector<std::size_t>> lists(nodes);
        for (const auto& [a, b] : wires) {
            lists[a].push_back(b);
            lists[b].push_back(a);
        }
        return lists;
    }
};

WiredGraph graph_of(TopologyRequest request) {
    request.host = "node"; // so that all nodes are processors
    const ProblemRegistry problems = known_problems(1);
    const Catalogue catalogue = known_kinds(problems);
    const ReadResult read = read_netlist_text(generate::generate(request, catalogue).text, catalogue);
    REQUIRE(read.network);
    WiredGraph graph{read.network->nodes.size()};
    for (const LinkConnection& wire : read.network->connections)
        graph.wires.emplace_back(wire.a.node, wire.b.node);
    return graph;
}

WiredGraph sized_graph(const std::string& topology, const std::string& size) {
    TopologyRequest request;
    request.topology = topology;
    request.size = size;
    return graph_of(request);
}

WiredGraph chordal_graph(const std::string& size, std::size_t chord, std::size_t degree) {
    TopologyRequest request;
    request.topology = "chordal-ring";
    request.size = size;
    request.chord = chord;
    request.degree = degree;
    return graph_of(request);
}

using Matrix = std::vector<std::vector<long double>>;

/// Subtracts multiples of row `pivot` from the rows below, so that their elements in this column become 0. Returns the
/// factor by which the determinant changes sign.
int eliminate_below(Matrix& rows, std::size_t pivot) {
    std::size_t greatest = pivot;
    for (std::size_t row = pivot; row < rows.size(); ++row)
        if (std::abs(rows[row][pivot]) > std::abs(rows[greatest][pivot]))
            greatest = row;
    std::swap(rows[pivot], rows[greatest]);
    for (std::size_t row = pivot + 1; row < rows.size(); ++row) {
        const long double factor = rows[row][pivot] / rows[pivot][pivot];
        for (std::size_t column = pivot; column < rows.size(); ++column)
            rows[row][column] -= factor * rows[pivot][column];
    }
    return greatest == pivot ? 1 : -1;
}

/// Counts the spanning trees by G. Kirchhoff's theorem (1847).
std::uint64_t spanning_trees(const WiredGraph& graph) {
    Matrix laplacian(graph.nodes, std::vector<long double>(graph.nodes));
    for (const auto& [a, b] : graph.wires) {
        laplacian[a][a] += 1;
        laplacian[b][b] += 1;
        laplacian[a][b] -= 1;
        laplacian[b][a] -= 1;
    }
    laplacian.pop_back(); // any row and its column are left out
    long double determinant = 1;
    for (std::size_t pivot = 0; pivot < laplacian.size(); ++pivot) {
        determinant *= eliminate_below(laplacian, pivot);
        determinant *= laplacian[pivot][pivot];
    }
    return static_cast<std::uint64_t>(std::llround(determinant));
}

/// Returns the length of the shortest cycle through a wire: the wire, and the shortest path around it; 0 if there is no
/// such path. REQUIRES: no two wires join the same processors.
std::size_t shortest_cycle_through(const std::pair<std::size_t, std::size_t>& wire, const WiredGraph& graph) {
    const auto neighbours = graph.neighbours();
    std::vector<std::size_t> length(graph.nodes), queue{wire.first};
    length[wire.first] = 1;
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (const std::size_t other : neighbours[queue[next]]) {
            const bool is_wire = queue[next] == wire.first && other == wire.second;
            if (is_wire || length[other] > 0)
                continue;
            length[other] = length[queue[next]] + 1;
            queue.push_back(other);
        }
    return length[wire.second];
}

/// Returns the girth, which is the length of the shortest cycle; 0 for a tree.
std::size_t girth(const WiredGraph& graph) {
    std::size_t shortest = 0;
    for (const auto& wire : graph.wires)
        if (const std::size_t length = shortest_cycle_through(wire, graph); length > 0)
            shortest = shortest == 0 ? length : std::min(shortest, length);
    return shortest;
}

bool has_two_colours(const WiredGraph& graph) {
    const auto neighbours = graph.neighbours();
    std::vector<std::optional<bool>> colours(graph.nodes);
    std::vector<std::size_t> queue{0};
    colours[0] = false;
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (const std::size_t other : neighbours[queue[next]]) {
            if (!colours[other])
                queue.push_back(other);
            colours[other] = colours[other].value_or(!*colours[queue[next]]);
            if (*colours[other] == *colours[queue[next]])
                return false;
        }
    return true;
}

/// Returns the least number of wires whose removal divides the processors into two halves; with an odd number of
/// processors one part has one processor more. REQUIRES: at most 16 processors.
std::size_t bisection_width(const WiredGraph& graph) {
    std::size_t least = graph.wires.size();
    for (std::uint32_t half = 0; half < 1U << graph.nodes; ++half) {
        if (static_cast<std::size_t>(std::popcount(half)) != graph.nodes / 2)
            continue;
        std::size_t cut = 0;
        for (const auto& [a, b] : graph.wires)
            cut += (half >> a ^ half >> b) & 1;
        least = std::min(least, cut);
    }
    return least;
}

struct KnownGraph {
    std::string name;
    WiredGraph graph;
    std::uint64_t trees;
    std::size_t girth, bisection; ///< bisection 0: the width is not known, or takes too long to compute
    bool bipartite;
};

/// The numbers of spanning trees are from the Encyclopedia of Integer Sequences (A001353, A007341, A006237), and from
/// the spectra of the graphs that have names.
std::vector<KnownGraph> known_graphs() {
    return {{"path", sized_graph("pipeline", "10"), 1, 0, 1, true},
            {"cycle", sized_graph("ring", "12"), 12, 12, 2, true},
            {"odd cycle", sized_graph("ring", "9"), 9, 9, 2, false},
            {"complete binary tree", sized_graph("tree", "15"), 1, 0, 1, true},
            {"star", sized_graph("star", "5"), 1, 0, 2, true},
            {"ladder", sized_graph("mesh", "2x4"), 56, 4, 2, true},
            {"grid 3x3", sized_graph("mesh", "3x3"), 192, 4, 4, true},
            {"grid 4x4", sized_graph("mesh", "4x4"), 100352, 4, 4, true},
            {"torus 3x3", sized_graph("torus", "3x3"), 11664, 3, 8, false},
            {"torus 4x4, a hypercube", sized_graph("torus", "4x4"), 42467328, 4, 8, true},
            {"square", sized_graph("hypercube", "4"), 4, 4, 2, true},
            {"cube", sized_graph("hypercube", "8"), 384, 4, 4, true},
            {"hypercube", sized_graph("hypercube", "16"), 42467328, 4, 8, true},
            {"truncated cube", sized_graph("cube-connected-cycles", "24"), 32400000, 3, 0, false},
            {"utility graph", chordal_graph("6", 3, 3), 81, 4, 5, true},
            {"cube as a chordal ring", chordal_graph("8", 3, 3), 384, 4, 4, true},
            {"Heawood", chordal_graph("14", 5, 3), 50421, 6, 7, true},
            {"Moebius and Kantor", chordal_graph("16", 5, 3), 248832, 6, 6, true},
            {"complete bipartite 4, 4", chordal_graph("8", 3, 4), 4096, 4, 8, true},
            {"ring with three tails", sized_graph("figure-e2", "3x3"), 3, 3, 2, false}};
}

} // namespace

TEST_CASE("generated machines have the spanning trees, girth, bisection width and colours of their graphs") {
    for (const KnownGraph& known : known_graphs()) {
        INFO(known.name);
        CHECK(spanning_trees(known.graph) == known.trees);
        CHECK(girth(known.graph) == known.girth);
        CHECK(has_two_colours(known.graph) == known.bipartite);
        if (known.bisection > 0)
            CHECK(bisection_width(known.graph) == known.bisection);
    }
}

TEST_CASE("cube-connected cycles have two colours if, and only if, their cycles have an even length") {
    CHECK(has_two_colours(sized_graph("cube-connected-cycles", "64")));
    CHECK(girth(sized_graph("cube-connected-cycles", "64")) == 4);
    CHECK_FALSE(has_two_colours(sized_graph("cube-connected-cycles", "160")));
    CHECK(girth(sized_graph("cube-connected-cycles", "160")) == 5);
}

TEST_CASE("neighbours in a hypercube differ in one bit of their numbers") {
    const WiredGraph cube = sized_graph("hypercube", "16");
    for (const auto& [a, b] : cube.wires)
        CHECK(std::has_single_bit(a ^ b));
}

TEST_CASE("the usual chord of a chordal ring is the greatest odd number up to the root of the size, at least 3") {
    for (const auto& [size, chord] : {std::pair("6", 3U), {"24", 3U}, {"26", 5U}, {"48", 5U}, {"50", 7U}})
        CHECK(sized_graph("chordal-ring", size).wires == chordal_graph(size, chord, 3).wires);
}
