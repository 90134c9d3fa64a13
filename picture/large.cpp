#include "picture/large.hpp"

#include "picture/blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace placedpar::picture {

namespace {

/// In a lane between two rows or columns: the least distance of a wire from the boxes, and the distance between wires,
/// in pixels.
constexpr double lane_start = 10, lane_gap = 6;
constexpr double most_sagitta = 0.05; ///< greatest distance between a chord and the arc that it replaces, in cells
constexpr double apart = 3;           ///< distance between blocks, in cells

/// The places of all nodes. Blocks, groups of nodes that are drawn together, are numbered from left to right. Block 0
/// has the single nodes.
struct LargeLayout {
    std::vector<Point> places;
    std::vector<std::size_t> block_of;            ///< block of each node
    std::vector<std::optional<double>> radii{{}}; ///< radius of each block that is a ring, in cells
};

/// Returns whether rows are at least a cell apart, so that wires fit between them.
bool is_in_rows(const Shape& shape) {
    std::set<double> rows;
    for (Point each : shape)
        rows.insert(each.y);
    return std::ranges::adjacent_find(rows, [](double one, double next) { return next < one + 1; }) == rows.end();
}

/// Places the largest block, the single nodes to its left, and the other blocks to its right.
class LargeArrangement {
public:
    LargeArrangement(const Network& network, const Wiring& wiring) : blocks_(blocks_of(network, wiring)) {
        layout_.places.resize(network.nodes.size());
        layout_.block_of.resize(network.nodes.size());
        std::ranges::stable_sort(blocks_, std::greater<>(), [](const Block& block) { return block.nodes.size(); });
    }

    LargeLayout arrange() {
        put(blocks_.front(), {});
        if (layout_.radii.back())
            middle_ = std::round(height_ / 2);
        for (const Block& block : std::span(blocks_).subspan(1))
            block.nodes.size() == 1 ? put_single(block.nodes.front()) : put(block, {right_ + apart, 0});
        return std::move(layout_);
    }

private:
    /// Places the block with its upper left corner at `corner`.
    void put(const Block& block, Point corner) {
        std::size_t count = block.nodes.size();
        bool round = count > 2 && is_circle(block.shapes.front());
        const Shape shape = round || is_in_rows(block.shapes.front()) ? block.shapes.front() : rectangle(count);
        Box extent = around(shape);
        for (std::size_t i = 0; i < count; ++i) {
            layout_.places[block.nodes[i]] = shape[i] + corner - Point{extent.left(), extent.top()};
            layout_.block_of[block.nodes[i]] = layout_.radii.size();
        }
        layout_.radii.push_back(round ? std::optional(extent.width / 2) : std::nullopt);
        right_ = corner.x + extent.width;
        height_ = std::max(height_, extent.height);
    }

    void put_single(std::size_t node) {
        auto rows = static_cast<std::size_t>(height_ - middle_) + 1;
        layout_.places[node] = {-apart - static_cast<double>(singles_ / rows),
                                middle_ + static_cast<double>(singles_ % rows)};
        ++singles_;
    }

    std::vector<Block> blocks_;
    LargeLayout layout_;
    double right_ = 0, height_ = 0;
    double middle_ = 0; ///< row of the first single node
    std::size_t singles_ = 0;
};

/// Routes wires. Within a block, wires use the lanes between rows and columns, or the inside of a ring. A wire between
/// two blocks leads to the side of each block; if other blocks are in between, it passes below all blocks.
class LargeRouter {
public:
    LargeRouter(const LargeLayout& layout, const std::vector<DrawnNode>& nodes)
        : layout_(layout), nodes_(nodes), blocks_(layout.radii.size()) {
        std::vector<std::vector<Box>> boxes(blocks_.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Box& box = nodes[i].box;
            Point at = layout.places[i];
            LargeBlock& block = blocks_[layout.block_of[i]];
            block.rows[at.y].add(at.x, box.top(), box.bottom());
            block.columns[at.x].add(at.y, box.left(), box.right());
            boxes[layout.block_of[i]].push_back(box);
            bottom_ = std::max(bottom_, box.bottom());
        }
        for (std::size_t i = 0; i < blocks_.size(); ++i)
            finish(i, boxes[i]);
    }

    Path route(std::size_t a, std::size_t b) {
        std::size_t from = layout_.block_of[a], to = layout_.block_of[b];
        if (from > to)
            return reversed(route(b, a));
        if (from != to)
            return joined(leave(a, true), leave(b, false), from + 1 == to);
        if (blocks_[from].radius)
            return within_ring(a, b);
        if (auto path = between_neighbours(a, b))
            return *path;
        if (!blocks_[from].in_columns)
            return joined(leave(a, true), leave(b, true), true);
        return layout_.places[a].x <= layout_.places[b].x ? through_lanes(a, b) : reversed(through_lanes(b, a));
    }

private:
    struct Line {
        std::map<double, std::size_t> positions; ///< rank of each node by its position along the line
        double first, last;                      ///< top and bottom of a row's boxes, or left and right of a column's
        std::size_t number = 0;

        void add(double position, double least, double most) {
            first = positions.empty() ? least : std::min(first, least);
            last = positions.empty() ? most : std::max(last, most);
            positions.emplace(position, 0);
        }
    };
    using Lines = std::map<double, Line>;

    struct LargeBlock {
        Lines rows, columns;
        bool in_columns = true; ///< whether wires fit between its columns
        Box extent;
        std::optional<double> radius; ///< radius in cells, if the block is a ring
    };

    static void number(Lines& lines) {
        std::size_t count = 0;
        for (auto& [at, line] : lines) {
            line.number = count++;
            std::size_t order = 0;
            for (auto& [position, place] : line.positions)
                place = order++;
        }
    }

    void finish(std::size_t index, const std::vector<Box>& boxes) {
        LargeBlock& block = blocks_[index];
        block.radius = layout_.radii[index];
        number(block.rows);
        number(block.columns);
        for (auto next = block.columns.begin(); next != block.columns.end(); ++next)
            if (next != block.columns.begin() && std::prev(next)->second.last > next->second.first - lane(0, 128))
                block.in_columns = false;
        if (!boxes.empty())
            block.extent = around(boxes);
    }

    static Path reversed(Path path) {
        std::ranges::reverse(path);
        return path;
    }

    const Box& box(std::size_t node) const { return nodes_[node].box; }
    const LargeBlock& block(std::size_t node) const { return blocks_[layout_.block_of[node]]; }
    const Line& row(std::size_t node) const { return block(node).rows.at(layout_.places[node].y); }
    const Line& column(std::size_t node) const { return block(node).columns.at(layout_.places[node].x); }

    static bool follow(const Line& line, double one, double other) {
        auto a = line.positions.at(one), b = line.positions.at(other);
        return a + 1 == b || b + 1 == a;
    }

    /// Returns the path between neighbours in a row, or between nodes in consecutive rows. Returns nullopt for other
    /// nodes.
    std::optional<Path> between_neighbours(std::size_t a, std::size_t b) const {
        Point at = layout_.places[a], to = layout_.places[b];
        if (at.y == to.y && follow(row(a), at.x, to.x)) {
            bool onward = at.x < to.x;
            return Path{{onward ? box(a).right() : box(a).left(), box(a).centre.y},
                        {onward ? box(b).left() : box(b).right(), box(b).centre.y}};
        }
        if (row(a).number + 1 == row(b).number)
            return down(a, b);
        if (row(b).number + 1 == row(a).number)
            return reversed(down(b, a));
        return std::nullopt;
    }

    Path down(std::size_t a, std::size_t b) const {
        Point from = box(a).centre, to = box(b).centre;
        Path path{{from.x, box(a).bottom()}};
        if (from.x != to.x)
            path.insert(path.end(), {{from.x, row(a).last + 1}, {to.x, row(b).first - 1}});
        path.push_back({to.x, box(b).top()});
        return path;
    }

    static double lane(std::size_t one, std::size_t other) {
        auto far = static_cast<unsigned>(std::max(one, other) - std::min(one, other));
        return lane_start + lane_gap * std::min(static_cast<double>(std::bit_width(far)), 7.);
    }

    double below(std::size_t node, double lane) const { return row(node).last + lane; }

    /// Returns a path from the bottom of node `a` to the bottom of node `b`. It leads below the row of `a`, along the
    /// lane to the right of the column of `a`, and below the row of `b`. If both nodes are in one row, the path needs
    /// no such lane.
    Path through_lanes(std::size_t a, std::size_t b) const {
        double flat = lane(column(a).number, column(b).number), steep = lane(row(a).number, row(b).number);
        Point from = box(a).centre, to = box(b).centre;
        Path path{{from.x, box(a).bottom()}, {from.x, below(a, flat)}};
        if (row(a).number != row(b).number) {
            double x = column(a).last + steep;
            path.insert(path.end(), {{x, below(a, flat)}, {x, below(b, flat)}});
        }
        path.insert(path.end(), {{to.x, below(b, flat)}, {to.x, box(b).bottom()}});
        path.erase(std::unique(path.begin(), path.end()), path.end());
        return path;
    }

    /// Returns a path from the node to a point beside its block. The path is straight if no box is in between;
    /// otherwise it leads below the node's row.
    Path leave(std::size_t node, bool rightward) const {
        if (block(node).radius)
            return out_of_ring(node, rightward);
        const Box &extent = block(node).extent, &self = box(node);
        double beside = lane_start + lane_gap * static_cast<double>(row(node).number % 8);
        double x = rightward ? extent.right() + beside : extent.left() - beside;
        std::size_t place = row(node).positions.at(layout_.places[node].x);
        if (place == (rightward ? row(node).positions.size() - 1 : 0))
            return {{rightward ? self.right() : self.left(), self.centre.y}, {x, self.centre.y}};
        double y = below(node, lane_start + lane_gap * static_cast<double>(column(node).number % 8));
        return {{self.centre.x, self.bottom()}, {self.centre.x, y}, {x, y}};
    }

    /// Joins the paths that leave two blocks. Paths between neighbouring blocks are joined directly, others below all
    /// blocks.
    Path joined(Path from, Path to, bool beside) const {
        double y = beside ? to.back().y : bottom_ + lane(0, 128) + lane_start;
        from.push_back({from.back().x, y});
        from.push_back({to.back().x, y});
        from.insert(from.end(), to.rbegin(), to.rend());
        from.erase(std::unique(from.begin(), from.end()), from.end());
        return from;
    }

    /// Returns the point that lies `cells` cells outside the node, on the line from the ring's centre through the node.
    Point beside_ring(std::size_t node, double cells) const {
        Point centre = block(node).extent.centre;
        return centre + (1 + cells / *block(node).radius) * (box(node).centre - centre);
    }

    Path within_ring(std::size_t a, std::size_t b) const {
        Point from = beside_ring(a, -0.6), to = beside_ring(b, -0.6);
        return {way_out(box(a), box(a).centre, from), from, to, way_out(box(b), box(b).centre, to)};
    }

    /// Returns a path from the node around its ring to the ring's left or right side.
    Path out_of_ring(std::size_t node, bool rightward) const {
        const Box& ring = block(node).extent;
        Point outside = beside_ring(node, 0.7), c = ring.centre;
        Path path{way_out(box(node), box(node).centre, outside), outside};
        double across = ring.width / 2, high = ring.height / 2, reach = 1 + 0.75 / *block(node).radius;
        double angle = std::atan2((outside.y - c.y) / high, (outside.x - c.x) / across),
               goal = rightward ? 0 : std::copysign(std::numbers::pi, angle);
        // A chord is nearer to the boxes than the arc that it replaces, but at most by most_sagitta. A ring of n nodes
        // takes about sqrt(n) chords.
        double chord = std::sqrt(8 * most_sagitta / *block(node).radius);
        int steps = static_cast<int>(std::ceil(std::abs(goal - angle) / chord));
        for (int i = 1; i <= steps; ++i) {
            double turn = angle + (goal - angle) * i / steps;
            path.push_back(c + Point{reach * across * std::cos(turn), reach * high * std::sin(turn)});
        }
        return path;
    }

    const LargeLayout& layout_;
    const std::vector<DrawnNode>& nodes_;
    std::vector<LargeBlock> blocks_;
    double bottom_ = 0; ///< lowest border of all boxes
};

} // namespace

std::pair<std::vector<DrawnNode>, std::vector<DrawnWire>> draw_large(const Network& network,
                                                                     const std::vector<Span>& spans) {
    LargeLayout layout = LargeArrangement(network, Wiring(network)).arrange();
    std::vector<DrawnNode> nodes = draw_nodes(network, {}, layout.places);
    std::vector<DrawnWire> wires(network.connections.size());
    LargeRouter router(layout, nodes);
    for (const Span& span : spans)
        wires[span.connection].spans.push_back(router.route(span.from.node, span.to.node));
    return {std::move(nodes), std::move(wires)};
}

} // namespace placedpar::picture
