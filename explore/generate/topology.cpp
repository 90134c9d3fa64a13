#include "explore/generate/topology.hpp"

#include "explore/generate/size.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace placedpar::generate {

namespace {

std::string val(const char* name, std::size_t value) { return fmt::format("val {} {};", name, value); }

/// Throws UserError if a processor has more neighbours than links.
void require_links(const TopologyRequest& request, std::size_t needed, const char* who, const char* instead) {
    if (needed > links_of_a_node)
        refuse_size(request, fmt::format("{} needs {} links, but a transputer has {} links; {}", who, needed,
                                         links_of_a_node, instead));
}

/// The text of `no_host` for topologies in which every processor has four neighbours.
constexpr const char* all_links_taken = "every processor has four neighbours and four links";

Topology pipeline(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 1);
    return {.about = fmt::format("A pipeline of {}", nodes),
            .vals = {val("nodes", nodes)},
            .wires = {{{"rep i = 0 for nodes - 1"}, {"[i]", "2", "i > 0"}, {"[i + 1]", "1", "0"}}}};
}

Wires around_the_ring() { return {{"rep i = 0 for nodes"}, {"[i]", "2", "0"}, {"[(i + 1) % nodes]", "1", "1"}}; }

Topology ring(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 3);
    return {.about = fmt::format("A ring of {}", nodes), .vals = {val("nodes", nodes)}, .wires = {around_the_ring()}};
}

Topology tree(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 1), branches = request.branches.value_or(2);
    if (branches == 0)
        refuse_size(request, "--branches must be 1, 2 or 3");
    require_links(request, branches + 1, "a processor with its parent and its children", "use --branches 3");
    return {.about = fmt::format("A tree of {}, each with up to {} children", nodes, branches),
            .vals = {val("nodes", nodes), val("branches", branches)},
            .wires = {{{"rep i = 1 for nodes - 1"},
                       {"[(i - 1) / branches]", "1 + (i - 1) % branches", "(i - 1) % branches + (i > branches)"},
                       {"[i]", "0", "0"}}}};
}

/// Makes a mesh of three dimensions. A node needs six links, so it consists of two processors. Number 0 has the wires
/// along the columns and to the previous row, number 1 the wires to the next row and along the planes.
Topology mesh_of_pairs(const TopologyRequest& request) {
    const Box box = box_of(request);
    return {.about = fmt::format("A mesh of {} planes, {} rows and {} columns; each node is two processors", box.planes,
                                 box.rows, box.columns),
            .vals = {val("planes", box.planes), val("rows", box.rows), val("columns", box.columns),
                     "val nodes 2 * planes * rows * columns;"},
            .array = "[planes][rows][columns][2]",
            .first = "[0][0][0][0]",
            .at = "[i / (2 * rows * columns)][i / (2 * columns) % rows][i / 2 % columns][i % 2]",
            .wires = {{{"rep p = 0 for planes", "rep r = 0 for rows", "rep c = 0 for columns"},
                       {"[p][r][c][0]", "0", "0"},
                       {"[p][r][c][1]", "0", "0"}},
                      {{"rep p = 0 for planes", "rep r = 0 for rows", "rep c = 0 for columns - 1"},
                       {"[p][r][c][0]", "2", "1 + (c > 0)"},
                       {"[p][r][c + 1][0]", "1", "1"}},
                      {{"rep p = 0 for planes", "rep r = 0 for rows - 1", "rep c = 0 for columns"},
                       {"[p][r][c][1]", "1", "1"},
                       {"[p][r + 1][c][0]", "3", "1 + (c > 0) + (c + 1 < columns)"}},
                      {{"rep p = 0 for planes - 1", "rep r = 0 for rows", "rep c = 0 for columns"},
                       {"[p][r][c][1]", "3", "1 + (r + 1 < rows) + (p > 0)"},
                       {"[p + 1][r][c][1]", "2", "1 + (r + 1 < rows)"}}},
            .host = {"", "0", "[0][0][0][0]", "1"},
            .nodes = 2 * box.planes * box.rows * box.columns};
}

Topology mesh(const TopologyRequest& request) {
    if (has_three_dimensions(request))
        return mesh_of_pairs(request);
    Grid grid = grid_of(request, 1, 1);
    return {.about = fmt::format("A mesh of {} rows and {} columns", grid.rows, grid.columns),
            .vals = {val("rows", grid.rows), val("columns", grid.columns), "val nodes rows * columns;"},
            .array = "[rows][columns]",
            .first = "[0][0]",
            .at = "[i / columns][i % columns]",
            .wires = {{{"rep r = 0 for rows", "rep c = 0 for columns - 1"},
                       {"[r][c]", "0", "(c > 0) + (r > 0)"},
                       {"[r][c + 1]", "1", "0"}},
                      {{"rep r = 0 for rows - 1", "rep c = 0 for columns"},
                       {"[r][c]", "2", "(c > 0) + (r > 0) + (c + 1 < columns)"},
                       {"[r + 1][c]", "3", "c > 0"}}},
            .host = {"", "0", "[0][0]", "1"}};
}

/// Makes a torus. In a row or column of two processors, only one wire joins the processors.
Topology torus(const TopologyRequest& request) {
    Grid grid = grid_of(request, 2, 2);
    bool full = grid.rows > 2 && grid.columns > 2;
    return {.about = fmt::format("A torus of {} rows and {} columns", grid.rows, grid.columns),
            .vals = {val("rows", grid.rows), val("columns", grid.columns), "val nodes rows * columns;"},
            .array = "[rows][columns]",
            .first = "[0][0]",
            .at = "[i / columns][i % columns]",
            .wires = {{{"rep r = 0 for rows", "rep c = 0 for columns > 2 ? columns : 1"},
                       {"[r][c]", "0", "0"},
                       {"[r][(c + 1) % columns]", "1", "columns > 2"}},
                      {{"rep r = 0 for rows > 2 ? rows : 1", "rep c = 0 for columns"},
                       {"[r][c]", "2", "1 + (columns > 2)"},
                       {"[(r + 1) % rows][c]", "3", "1 + (columns > 2) + (rows > 2)"}}},
            .host = {"", "0", "[0][0]", "columns > 2 ? 3 : 1"},
            .no_host = full ? all_links_taken : ""};
}

Topology hypercube(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 1);
    if (!std::has_single_bit(nodes))
        refuse_size(request, fmt::format("the number of processors must be a power of two, such as {} or {}",
                                         std::bit_floor(nodes), std::bit_ceil(nodes)));
    auto dimensions = static_cast<std::size_t>(std::countr_zero(nodes));
    require_links(request, dimensions, "every processor", "use at most size 16, or cube-connected-cycles");
    return {.about = fmt::format("A hypercube of {} dimensions", dimensions),
            .vals = {val("dimensions", dimensions), "val nodes 1 << dimensions;"},
            .wires = {{{"rep d = 0 for dimensions", "rep i = 0 for nodes", "if (i & 1 << d) == 0"},
                       {"[i]", "d", "d"},
                       {"[i ^ 1 << d]", "d", "d"}}},
            .host = {"", "0", "[0]", "dimensions"},
            .no_host = dimensions == links_of_a_node ? all_links_taken : ""};
}

/// Makes cube-connected cycles (F. P. Preparata, J. Vuillemin, Communications of the ACM 24, 1981). Each corner of the
/// cube is a cycle with one processor for each dimension. The wire of a dimension is at the processor of this
/// dimension.
Topology cube_connected_cycles(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 1), dimensions = 3;
    while (dimensions << dimensions < nodes)
        ++dimensions;
    if (dimensions << dimensions != nodes)
        refuse_size(request, "the size must be d * 2^d for some dimension d: 24, 64, 160, 384, 896 or 2048");
    return {.about = fmt::format("Cube-connected cycles of {} dimensions", dimensions),
            .vals = {val("dimensions", dimensions), "val corners 1 << dimensions;", "val nodes corners * dimensions;"},
            .array = "[corners][dimensions]",
            .first = "[0][0]",
            .at = "[i / dimensions][i % dimensions]",
            .wires = {{{"rep w = 0 for corners", "rep d = 0 for dimensions"},
                       {"[w][d]", "0", "0"},
                       {"[w][(d + 1) % dimensions]", "1", "1"}},
                      {{"rep w = 0 for corners", "rep d = 0 for dimensions", "if (w & 1 << d) == 0"},
                       {"[w][d]", "2", "2"},
                       {"[w ^ 1 << d][d]", "2", "2"}}},
            .host = {"", "0", "[0][0]", "3"}};
}

Topology star(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 1);
    require_links(request, nodes - 1, "its centre", "use at most size 5, or a tree");
    return {.about = fmt::format("A star of {}: a centre that is connected with all others", nodes),
            .vals = {val("nodes", nodes)},
            .wires = {{{"rep i = 1 for nodes - 1"}, {"[0]", "i - 1", "i - 1"}, {"[i]", "0", "0"}}},
            .host = {"", "0", "[nodes == 5]", "nodes == 5 ? 1 : 3"}};
}

/// Returns a nearly optimal chord: the largest odd number not above the square root of `nodes`, at least 3.
std::size_t usual_chord(std::size_t nodes) {
    std::size_t chord = 3;
    while ((chord + 2) * (chord + 2) <= nodes)
        chord += 2;
    return chord;
}

/// Makes a chordal ring of degree 3 (B. W. Arden, H. Lee: Analysis of chordal ring network, IEEE Transactions on
/// Computers C-30, 1981). A chord leads from each even processor to an odd processor.
Topology chordal_ring_of_three(const TopologyRequest& request, std::size_t nodes, std::size_t chord) {
    if (nodes % 2 == 1 || chord % 2 == 0)
        refuse_size(request,
                    fmt::format("with three links for each processor, chords lead from even to odd processors: "
                                "the size must be even and the chord odd (the chord is {}); or use --degree 4",
                                chord));
    return {.about =
                fmt::format("A chordal ring of {}, with chords of length {} from even to odd processors", nodes, chord),
            .vals = {val("nodes", nodes), val("chord", chord)},
            .wires = {around_the_ring(),
                      {{"rep k = 0 for nodes / 2"}, {"[2 * k]", "3", "2"}, {"[(2 * k + chord) % nodes]", "3", "2"}}}};
}

Topology chordal_ring_of_four(const TopologyRequest& request, std::size_t nodes, std::size_t chord) {
    if (2 * chord >= nodes)
        refuse_size(request, fmt::format("with four links for each processor, the chord {} must be less than half "
                                         "of the size",
                                         chord));
    return {
        .about = fmt::format("A chordal ring of {}, with a chord of length {} from each processor", nodes, chord),
        .vals = {val("nodes", nodes), val("chord", chord)},
        .wires = {around_the_ring(), {{"rep i = 0 for nodes"}, {"[i]", "3", "2"}, {"[(i + chord) % nodes]", "0", "3"}}},
        .no_host = all_links_taken};
}

Topology chordal_ring(const TopologyRequest& request) {
    std::size_t nodes = count_of(request, 6), chord = request.chord.value_or(usual_chord(nodes));
    std::size_t degree = request.degree.value_or(3);
    if (degree != 3 && degree != 4)
        refuse_size(request,
                    fmt::format("--degree {}: expected 3 or 4 links for each processor of a chordal ring", degree));
    if (chord < 2 || chord + 1 >= nodes)
        refuse_size(request, fmt::format("a chord of length {} leads to a neighbour or around the whole ring; use a "
                                         "chord from 2 to half of the size",
                                         chord));
    return degree == 3 ? chordal_ring_of_three(request, nodes, chord) : chordal_ring_of_four(request, nodes, chord);
}

/// Makes the machine of Figure E.2. Each master has its own link to the host.
Topology figure_e2(const TopologyRequest& request) {
    Grid grid = grid_of(request, 1, 1);
    return {.about = fmt::format("Figure E.2 of the thesis: a ring of {}, each at the head of a chain of {}", grid.rows,
                                 grid.columns),
            .vals = {val("clusters", grid.rows), val("slaves", grid.columns - 1), "val nodes clusters * (slaves + 1);"},
            .array = "[clusters][slaves + 1]",
            .first = "[0][0]",
            .at = "[i / (slaves + 1)][i % (slaves + 1)]",
            .wires = {{{"rep c = 0 for clusters > 2 ? clusters : clusters - 1"},
                       {"[c][0]", "1", "0"},
                       {"[(c + 1) % clusters][0]", "2", "clusters > 2"}},
                      {{"rep c = 0 for clusters", "rep i = 0 for slaves"},
                       {"[c][i]", "3", "i > 0 ? 1 : (clusters > 1) + (clusters > 2)"},
                       {"[c][i + 1]", "1", "0"}}},
            .host = {"rep c = 0 for clusters", "c", "[c][0]", "0"}};
}

struct NamedTopology {
    const char* name;
    Topology (*make)(const TopologyRequest&);
};
constexpr std::array<NamedTopology, 10> topologies{{
    {.name = "pipeline", .make = pipeline},
    {.name = "ring", .make = ring},
    {.name = "tree", .make = tree},
    {.name = "mesh", .make = mesh},
    {.name = "torus", .make = torus},
    {.name = "hypercube", .make = hypercube},
    {.name = "cube-connected-cycles", .make = cube_connected_cycles},
    {.name = "star", .make = star},
    {.name = "chordal-ring", .make = chordal_ring},
    {.name = "figure-e2", .make = figure_e2},
}};

void require_own_options(const TopologyRequest& request) {
    if (request.branches && request.topology != "tree")
        throw UserError("--branches works only with the topology tree");
    if ((request.chord || request.degree) && request.topology != "chordal-ring")
        throw UserError("--chord and --degree work only with the topology chordal-ring");
    if (request.split)
        throw UserError("--split works only with a graph from a file");
    if (request.size.empty())
        throw UserError(fmt::format("--size is required for the topology {}", request.topology));
}

} // namespace

std::vector<std::string> names_of_topologies() {
    std::vector<std::string> names;
    for (const NamedTopology& each : topologies)
        names.emplace_back(each.name);
    return names;
}

Topology topology_of(const TopologyRequest& request) {
    const auto* found = std::ranges::find(topologies, request.topology, &NamedTopology::name);
    if (found == topologies.end())
        throw UserError(unknown_name("topology", request.topology, names_of_topologies(),
                                     fmt::format("expected one of: {}", fmt::join(names_of_topologies(), ", "))));
    require_own_options(request);
    Topology topology = found->make(request);
    if (topology.nodes == 0)
        topology.nodes = product_of_size(request);
    return topology;
}

} // namespace placedpar::generate
