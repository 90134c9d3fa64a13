#include "picture/arrange.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "picture/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace placedpar::picture {

namespace {

/// The approximate size of a node's box, in cells.
constexpr double box_width = 0.7, box_height = 0.6;
/// The cost of a wire is the square of its length, plus `across_a_box` for each box that it crosses, plus `diagonal`
/// times the smaller of its width and height.
constexpr double across_a_box = 6, diagonal = 0.5;

/// Stores the placed nodes by cell, so that the nodes near a place are found quickly.
class NodeGrid {
public:
    void put(std::size_t node, Point at) { cells_[cell(at)].push_back({node, at}); }

    bool is_free(Point at) const {
        for (double dx : {-1., 0., 1.})
            for (double dy : {-1., 0., 1.})
                if (!leaves_room(cell(at + Point{dx, dy}), at))
                    return false;
        return true;
    }

private:
    struct PlacedNode {
        std::size_t node;
        Point at;
    };
    using Cell = std::pair<int, int>;

    static Cell cell(Point p) { return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))}; }

    bool leaves_room(Cell cell, Point at) const {
        auto found = cells_.find(cell);
        return found == cells_.end() || std::ranges::none_of(found->second, [&](const PlacedNode& each) {
                   return std::abs(each.at.x - at.x) < 1 && std::abs(each.at.y - at.y) < 1;
               });
    }

    std::map<Cell, std::vector<PlacedNode>> cells_;
};

Box box_at(Point at) { return {at, box_width, box_height}; }

/// A group of blocks that wires connect with each other.
class Group {
public:
    Group(const Network& network, const Wiring& wiring, std::vector<Point>& places)
        : n_(network), wiring_(wiring), places_(places), placed_(network.nodes.size(), false) {}

    bool empty() const { return nodes_.empty(); }

    std::size_t wires_to(const Block& block) const {
        std::size_t wires = 0;
        for (auto node : block.nodes)
            for (auto other : wiring_.neighbours(node))
                wires += placed_[other] ? 1U : 0U;
        return wires;
    }

    void put(const Block& block) {
        Choice best;
        for (const Shape& shape : block.shapes)
            consider(block, shape, best);
        for (std::size_t i = 0; i < block.nodes.size(); ++i)
            stand(block.nodes[i], best.offset + (*best.shape)[i]);
    }

    /// Moves the group so that its upper left corner is at `corner`, and returns its new extent.
    Box move_to(Point corner) {
        Box now = around(points());
        for (auto node : nodes_)
            places_[node] = places_[node] + corner - Point{now.left(), now.top()};
        return around(points());
    }

private:
    struct Choice {
        const Shape* shape = nullptr;
        Point offset;
        double cost = std::numeric_limits<double>::max();
    };

    std::vector<Point> points() const {
        std::vector<Point> result;
        for (auto node : nodes_)
            result.push_back(places_[node]);
        return result;
    }

    void stand(std::size_t node, Point at) {
        places_[node] = at;
        placed_[node] = true;
        nodes_.push_back(node);
        grid_.put(node, at);
    }

    /// Tries all offsets, in steps of half a cell, that place the shape among the placed nodes or beside them. Stores
    /// the cheapest offset in `best` if it is cheaper than `best`.
    void consider(const Block& block, const Shape& shape, Choice& best) {
        if (empty()) {
            if (!best.shape)
                best = {&shape, {}, 0};
            return;
        }
        Box there = around(points()), here = around(shape);
        for (double y = std::floor(there.top() - here.bottom()) - 1; y <= there.bottom() - here.top() + 1; y += 0.5)
            for (double x = std::floor(there.left() - here.right()) - 1; x <= there.right() - here.left() + 1; x += 0.5)
                consider_at(block, shape, {x, y}, best);
    }

    void consider_at(const Block& block, const Shape& shape, Point offset, Choice& best) {
        double cost = length_of_wires(block, shape, offset, best.cost);
        if (cost >= best.cost || !fits(shape, offset))
            return;
        cost += cost_of_crossings(block, shape, offset);
        if (cost < best.cost)
            best = {&shape, offset, cost};
    }

    bool fits(const Shape& shape, Point offset) const {
        return std::ranges::all_of(shape, [&](Point each) { return grid_.is_free(offset + each); });
    }

    /// Returns the cost of the block's wires to placed nodes. The sum ends early when it reaches `enough`.
    double length_of_wires(const Block& block, const Shape& shape, Point offset, double enough) const {
        double cost = 0;
        for (std::size_t i = 0; i < block.nodes.size() && cost < enough; ++i)
            for (auto other : wiring_.neighbours(block.nodes[i]))
                if (placed_[other])
                    cost += cost_of(block.nodes[i], places_[other] - (offset + shape[i]));
        return cost;
    }

    /// Returns the cost of a wire from the new node along the vector `way`. If two places have equal costs, the result
    /// prefers the left or upper place for a host or an edge, and the right or lower place for any other node.
    double cost_of(std::size_t node, Point way) const {
        bool leads = n_.nodes[node].kind->drawing.in_first_row || n_.nodes[node].kind->links == LinkRole::edge;
        double towards = leads ? -1 : 1;
        double slant = std::min(std::abs(way.x), std::abs(way.y));
        return way.x * way.x + way.y * way.y + diagonal * slant + 0.001 * towards * way.x + 0.0008 * towards * way.y;
    }

    /// Returns the cost of the placed boxes that new wires cross, and of the placed wires that cross new boxes.
    double cost_of_crossings(const Block& block, const Shape& shape, Point offset) const {
        double cost = 0;
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
            for (auto other : wiring_.neighbours(block.nodes[i]))
                if (placed_[other])
                    cost += across_a_box * boxes_between(block.nodes[i], offset + shape[i], other);
            cost += across_a_box * wires_across(offset + shape[i]);
        }
        return cost;
    }

    double boxes_between(std::size_t node, Point at, std::size_t other) const {
        double count = 0;
        for (auto each : nodes_)
            count += each != node && each != other && crosses(box_at(places_[each]), at, places_[other]) ? 1 : 0;
        return count;
    }

    double wires_across(Point at) const {
        double count = 0;
        for (auto node : nodes_)
            for (auto other : wiring_.neighbours(node))
                count += node < other && placed_[other] && crosses(box_at(at), places_[node], places_[other]) ? 1 : 0;
        return count;
    }

    const Network& n_;
    const Wiring& wiring_;
    std::vector<Point>& places_; ///< place of each node of the network
    std::vector<bool> placed_;
    std::vector<std::size_t> nodes_;
    NodeGrid grid_;
};

class Arrangement {
public:
    Arrangement(const Network& network, const Wiring& wiring)
        : n_(network), wiring_(wiring), blocks_(blocks_of(network, wiring)), places_(network.nodes.size()) {}

    std::vector<Point> arrange() {
        std::vector<Group> groups;
        while (!blocks_.empty())
            groups.push_back(next_group());
        set_beside(groups);
        return std::move(places_);
    }

private:
    /// Returns the block with the most wires to the group. If several blocks have this number of wires, returns the
    /// block with the most nodes; if these numbers are also equal, the block declared first.
    std::size_t next_block(const Group& group) const {
        auto rank = [&](const Block& block) {
            auto first = static_cast<std::ptrdiff_t>(block.nodes.front());
            return std::tuple(group.wires_to(block), block.nodes.size(), -first);
        };
        auto best = std::ranges::max_element(blocks_, {}, rank);
        return static_cast<std::size_t>(best - blocks_.begin());
    }

    Block take(std::size_t index) {
        Block block = std::move(blocks_[index]);
        blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(index));
        return block;
    }

    Group next_group() {
        Group group(n_, wiring_, places_);
        while (!blocks_.empty()) {
            auto next = next_block(group);
            if (!group.empty() && group.wires_to(blocks_[next]) == 0)
                break;
            group.put(take(next));
        }
        return group;
    }

    /// Puts the groups into rows about as wide as the widest group.
    void set_beside(std::vector<Group>& groups) {
        double longest = 4, bottom = 0;
        for (Group& group : groups)
            longest = std::max(longest, group.move_to({}).width);
        Point corner;
        for (Group& group : groups) {
            Box taken = group.move_to(corner);
            if (corner.x > 0 && taken.right() > longest) {
                corner = {0, bottom + 1.5};
                taken = group.move_to(corner);
            }
            bottom = std::max(bottom, taken.bottom());
            corner.x = taken.right() + 1.5;
        }
    }

    const Network& n_;
    const Wiring& wiring_;
    std::vector<Block> blocks_;
    std::vector<Point> places_;
};

} // namespace

std::vector<Point> arrange(const Network& network, const Wiring& wiring) {
    return Arrangement(network, wiring).arrange();
}

} // namespace placedpar::picture
