#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/network/network.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstddef>
#include <initializer_list>
#include <random>
#include <string>
#include <utility>

namespace placedpar::picture {

/// Returns the network of a netlist's text, with the CSP kinds.
inline Network network_of(const std::string& text) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    ReadResult result = read_netlist_text(text, catalogue);
    CAPTURE(text);
    CAPTURE(render(result));
    REQUIRE(result.network);
    return std::move(*result.network);
}

/// Returns the number of the node of this name.
inline std::size_t node_named(const Network& network, const std::string& name) {
    for (std::size_t i = 0; i < network.nodes.size(); ++i)
        if (network.nodes[i].name == name)
            return i;
    FAIL("no node " << name);
    return 0;
}

inline std::string chain(int count) {
    return fmt::format("T800 t[{}]; rep i = 0 for {} connect t[i].link[1] to t[i + 1].link[0];", count, count - 1);
}

inline std::string ring(int count) {
    return fmt::format("T800 t[{0}]; rep i = 0 for {0} connect t[i].link[1] to t[(i + 1) % {0}].link[0];", count);
}

inline std::string torus(int rows, int columns) {
    return fmt::format("T800 t[{0}][{1}]; rep i = 0 for {0} rep j = 0 for {1} {{\n"
                       "  connect t[i][j].link[1] to t[i][(j + 1) % {1}].link[0];\n"
                       "  connect t[i][j].link[3] to t[(i + 1) % {0}][j].link[2]; }}",
                       rows, columns);
}

/// Returns a hypercube of at most four dimensions: a node for each corner, and a wire for each edge.
inline std::string cube(int dimensions) {
    std::string text = fmt::format("T800 t[{}];\n", 1 << dimensions);
    for (int corner = 0; corner < 1 << dimensions; ++corner)
        for (int bit = 0; bit < dimensions; ++bit)
            if (int other = corner ^ 1 << bit; other > corner)
                text += fmt::format("connect t[{0}].link[{2}] to t[{1}].link[{2}];\n", corner, other, bit);
    return text;
}

/// Returns a random tree of single transputers. Each is wired to an earlier transputer that has a free link.
inline std::string random_tree(std::size_t count, unsigned seed) {
    std::mt19937 lots(seed);
    std::string text;
    std::vector<int> used(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        text += fmt::format("T800 n{};\n", i);
        if (i == 0)
            continue;
        std::size_t above = lots() % i;
        while (used[above] == 4)
            above = (above + 1) % i;
        text += fmt::format("connect n{}.link[{}] to n{}.link[{}];\n", above, used[above]++, i, used[i]++);
    }
    return text;
}

/// Returns a chain whose remaining links are wired in random pairs; no node is wired to itself.
inline std::string random_wiring(int count, unsigned seed) {
    std::mt19937 lots(seed);
    std::vector<std::pair<int, int>> links;
    for (int i = 0; i < count; ++i)
        for (int link = 2; link < 4; ++link)
            links.emplace_back(i, link);
    for (std::size_t i = links.size(); i > 1; --i)
        std::swap(links[i - 1], links[lots() % i]);
    std::string text = chain(count) + "\n";
    for (std::size_t i = 0; i + 1 < links.size(); i += 2)
        if (auto [a, b] = std::pair(links[i], links[i + 1]); a.first != b.first)
            text += fmt::format("connect t[{}].link[{}] to t[{}].link[{}];\n", a.first, a.second, b.first, b.second);
    return text;
}

/// Returns a producer on the first node, a consumer on the last node, and a channel between the two processes.
inline std::string stream(const std::string& from, const std::string& to) {
    return fmt::format("process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
                       "place p on {}; place c on {}; connect p.out to c.in;\n",
                       from, to);
}

} // namespace placedpar::picture
