#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::picture {

/// A stretch of a wire between two devices that it leads to or through; a wire through one switch has two.
struct Span {
    std::size_t connection = 0;
    LinkEnd from, to;
    std::string from_label, to_label; ///< what is written at its ends: the numbers of links
};

/// Of all wires: from each wire's a to its b.
std::vector<Span> spans_of(const Network&);

/// Which nodes a wire leads to from where.
class Wiring {
public:
    explicit Wiring(const Network&);

    bool linked(std::size_t a, std::size_t b) const { return pairs_.contains({a, b}); }
    /// As often as there are wires.
    const std::vector<std::size_t>& neighbours(std::size_t node) const { return neighbours_[node]; }

private:
    std::vector<std::vector<std::size_t>> neighbours_;
    std::set<std::pair<std::size_t, std::size_t>> pairs_;
};

} // namespace placedpar::picture
