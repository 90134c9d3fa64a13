#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// A part of a wire between two successive devices, such as switches, on the wire. A wire through one switch has two
/// spans.
struct Span {
    std::size_t connection = 0;
    LinkEnd from, to;
    std::string from_label, to_label; ///< labels at the ends of the span: numbers of links
};

/// Returns the spans of all wires. The spans of a wire are in order from its end `a` to its end `b`.
std::vector<Span> spans_of(const Network&);

/// The neighbours of each node, which are the nodes to which wires lead.
class Wiring {
public:
    explicit Wiring(const Network&);

    bool linked(std::size_t a, std::size_t b) const { return pairs_.contains({a, b}); }
    /// Returns the node's neighbours, with one entry for each wire.
    const std::vector<std::size_t>& neighbours(std::size_t node) const { return neighbours_[node]; }

private:
    std::vector<std::vector<std::size_t>> neighbours_;
    std::set<std::pair<std::size_t, std::size_t>> pairs_;
};

} // namespace placedpar::picture
