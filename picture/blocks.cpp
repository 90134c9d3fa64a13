#include "picture/blocks.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "netlist/network/names.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <string>
#include <utility>

namespace placedpar::picture {

namespace {

constexpr std::size_t longest_row = 8, largest_circle = 40, largest_cube = 160;

using Nodes = std::vector<std::size_t>;

/// Recognises the pattern in which the nodes of a block are wired with each other and with other nodes.
class Pattern {
public:
    Pattern(const Network& network, const Wiring& wiring, const Nodes& nodes)
        : n_(network), wiring_(wiring), nodes_(nodes) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            position_.emplace(nodes[i], i);
    }

    bool is_line() const {
        for (std::size_t i = 0; i + 1 < nodes_.size(); ++i)
            if (!wiring_.linked(nodes_[i], nodes_[i + 1]))
                return false;
        return true;
    }

    bool is_ring() const { return nodes_.size() > 2 && is_line() && wiring_.linked(nodes_.back(), nodes_.front()); }

    /// Returns whether each node is wired to exactly the nodes whose positions differ from its own in one bit.
    bool is_hypercube() const {
        if (nodes_.size() < 8 || !std::has_single_bit(nodes_.size()))
            return false;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!is_corner(i))
                return false;
        return true;
    }

    /// Returns whether the nodes form cube-connected cycles: 2^length rows of `length` nodes each. Each row is a ring.
    /// Node i of a row is wired to node i of the row whose number differs in bit i.
    bool is_cube_of_cycles(std::size_t length) const {
        if (length < 3 || length > 16 || nodes_.size() != length << length)
            return false;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!is_on_cycle(i / length, i % length, length))
                return false;
        return true;
    }

    /// Returns the parent of each node if the nodes are wired into a tree; empty otherwise. The root is the first node
    /// with a wire to a node outside the block; if there is none, it is the first node.
    std::vector<std::size_t> tree() const {
        std::vector<std::size_t> above(nodes_.size(), no_node);
        std::vector<std::size_t> reached{root()};
        std::set<std::size_t> seen{root()};
        // Several wires may join a node to its parent.
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (auto other : inside(reached[next]))
                if (other != above[reached[next]] && above[other] != reached[next]) {
                    if (!seen.insert(other).second)
                        return {};
                    above[other] = reached[next];
                    reached.push_back(other);
                }
        return reached.size() == nodes_.size() ? above : std::vector<std::size_t>{};
    }

    bool has_wires_inside() const {
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!inside(i).empty())
                return true;
        return false;
    }

    /// Returns whether there is another node that is wired to all nodes of the block.
    bool has_hub() const {
        return std::ranges::any_of(wiring_.neighbours(nodes_.front()), [&](std::size_t hub) {
            return std::ranges::all_of(nodes_, [&](std::size_t node) { return wiring_.linked(hub, node); });
        });
    }

    /// Returns whether each node of the block is wired to the node with the same subscript in another array, such as
    /// `row[i]` to `head[i]`.
    bool has_partners() const {
        std::map<std::string_view, std::size_t> partners; // by array: number of nodes that have a partner in the array
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            for (auto base : bases_of_partners(i))
                ++partners[base];
        return std::ranges::any_of(partners, [&](const auto& each) { return each.second == nodes_.size(); });
    }

private:
    /// Returns the positions within the block to which wires lead from position i, in ascending order, with one entry
    /// for each wire.
    std::vector<std::size_t> inside(std::size_t i) const {
        std::vector<std::size_t> others;
        for (auto other : wiring_.neighbours(nodes_[i]))
            if (auto found = position_.find(other); found != position_.end())
                others.push_back(found->second);
        std::ranges::sort(others);
        return others;
    }

    std::size_t root() const {
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (inside(i).size() < wiring_.neighbours(nodes_[i]).size())
                return i;
        return 0;
    }

    bool is_corner(std::size_t i) const {
        auto others = inside(i);
        return others.size() == static_cast<std::size_t>(std::countr_zero(nodes_.size())) &&
               std::ranges::all_of(others, [&](std::size_t other) { return std::has_single_bit(other ^ i); });
    }

    bool is_on_cycle(std::size_t row, std::size_t position, std::size_t length) const {
        auto node = nodes_[row * length + position], next = nodes_[row * length + (position + 1) % length];
        auto across = nodes_[(row ^ std::size_t{1} << position) * length + position];
        return wiring_.linked(node, next) && wiring_.linked(node, across);
    }

    std::set<std::string_view> bases_of_partners(std::size_t i) const {
        std::set<std::string_view> bases;
        auto subscript = subscripts_of(n_.nodes[nodes_[i]].name);
        for (auto other : wiring_.neighbours(nodes_[i])) {
            auto theirs = subscripts_of(n_.nodes[other].name);
            bool partner = !position_.contains(other) && !subscript.empty() && !theirs.empty() &&
                           (theirs.front() == subscript.front() || theirs.back() == subscript.front());
            if (partner)
                bases.insert(base_name(n_.nodes[other].name));
        }
        return bases;
    }

    const Network& n_;
    const Wiring& wiring_;
    const Nodes& nodes_;
    std::map<std::size_t, std::size_t> position_;
};

std::vector<Shape> lines(std::size_t count, bool wired) {
    if (count <= longest_row)
        return {row(count), column(count)};
    return {wired ? snake(count, longest_row) : rectangle(count), row(count), column(count)};
}

std::vector<Shape> shapes_in_order(const Pattern& pattern, std::size_t count) {
    if (pattern.is_hypercube())
        return {hypercube(static_cast<std::size_t>(std::countr_zero(count)))};
    if (pattern.has_partners())
        return {column(count), row(count)};
    bool round = count > 2 && count <= largest_circle;
    if (pattern.is_ring())
        return {circle(count)};
    if (count > 2 && pattern.has_hub() && !pattern.has_wires_inside())
        return {star(count)};
    if (auto hangs_from = pattern.tree(); !hangs_from.empty() && !pattern.is_line())
        return {picture::tree(hangs_from)};
    if (pattern.is_line() || !pattern.has_wires_inside())
        return lines(count, pattern.is_line());
    return {round ? circle(count) : rectangle(count)};
}

class BlockFinder {
public:
    BlockFinder(const Network& network, const Wiring& wiring) : n_(network), wiring_(wiring) {}

    std::vector<Block> find() {
        find_arrays();
        for (std::size_t i = 0; i < n_.nodes.size(); ++i)
            if (is_single(i) && !taken_.contains(i))
                add_singles(i);
        return std::move(blocks_);
    }

private:
    bool is_single(std::size_t node) const { return subscripts_of(n_.nodes[node].name).empty(); }

    void find_arrays() {
        std::map<std::string_view, Nodes> arrays;
        for (std::size_t i = 0; i < n_.nodes.size(); ++i)
            if (!is_single(i))
                arrays[base_name(n_.nodes[i].name)].push_back(i);
        for (const auto& [name, nodes] : arrays)
            add_array(nodes);
    }

    void add_array(const Nodes& nodes) {
        std::vector<std::vector<std::int64_t>> subscripts;
        for (auto node : nodes)
            subscripts.push_back(subscripts_of(n_.nodes[node].name));
        auto columns = static_cast<std::size_t>(subscripts.back().back()) + 1;
        bool small = subscripts.front().size() == 2 && nodes.size() <= largest_cube;
        if (small && Pattern(n_, wiring_, nodes).is_cube_of_cycles(columns))
            blocks_.push_back({nodes, {cube_connected_cycles(columns)}});
        else if (subscripts.front().size() == 1 || Pattern(n_, wiring_, nodes).is_hypercube())
            add_in_order(nodes);
        else
            blocks_.push_back({nodes, {grid(subscripts)}});
    }

    void add_in_order(const Nodes& nodes) {
        taken_.insert(nodes.begin(), nodes.end());
        blocks_.push_back({nodes, shapes_in_order(Pattern(n_, wiring_, nodes), nodes.size())});
    }

    bool is_single_processor(std::size_t node) const { return is_single(node) && n_.nodes[node].kind->has_executive(); }

    /// Returns the single processors that this single processor is wired to; empty for other nodes.
    std::set<std::size_t> singles_beside(std::size_t node) const {
        std::set<std::size_t> others;
        if (is_single_processor(node))
            for (auto other : wiring_.neighbours(node))
                if (is_single_processor(other))
                    others.insert(other);
        return others;
    }

    /// Returns this node and all single processors that are connected with it through single processors.
    std::set<std::size_t> singles_around(std::size_t start) const {
        std::set<std::size_t> found{start};
        Nodes reached{start};
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (auto other : singles_beside(reached[next]))
                if (found.insert(other).second)
                    reached.push_back(other);
        return found;
    }

    /// Adds the single nodes around `start`. If they form a line, a ring or a tree, they become one block; otherwise
    /// each node becomes a block.
    void add_singles(std::size_t start) {
        auto found = singles_around(start);
        bool line = std::ranges::all_of(found, [&](auto node) { return singles_beside(node).size() <= 2; });
        Nodes nodes(found.begin(), found.end());
        if (line)
            add_in_order(walk(nodes));
        else if (!Pattern(n_, wiring_, nodes).tree().empty())
            add_in_order(nodes);
        else
            for (auto node : nodes)
                add_in_order({node});
    }

    /// Returns the nodes in order along the line, from one of its ends, or around the ring, from its first node.
    Nodes walk(const Nodes& nodes) const {
        auto end = std::ranges::find_if(nodes, [&](auto node) { return singles_beside(node).size() < 2; });
        Nodes walked{end == nodes.end() ? nodes.front() : *end};
        std::set<std::size_t> seen{walked.front()};
        while (walked.size() < nodes.size())
            for (auto next : singles_beside(walked.back()))
                if (seen.insert(next).second) {
                    walked.push_back(next);
                    break;
                }
        return walked;
    }

    const Network& n_;
    const Wiring& wiring_;
    std::set<std::size_t> taken_;
    std::vector<Block> blocks_;
};

} // namespace

std::vector<Block> blocks_of(const Network& network, const Wiring& wiring) {
    return BlockFinder(network, wiring).find();
}

} // namespace placedpar::picture
