#include "workbench/picture/large.hpp"

#include "workbench/picture/blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace placedpar::picture {

namespace {

constexpr double lane_start = 10, lane_gap = 6; ///< of wires beside each other between two rows or columns
constexpr double apart = 3;                     ///< of blocks, in cells

/// The ring that a large network has as its largest block, in cells.
struct LargeRing {
    Point centre;
    double radius = 0;
};

struct LargeLayout {
    std::vector<Point> places;
    std::vector<bool> on_ring;
    std::optional<LargeRing> ring;
    std::optional<std::size_t> hub; ///< in the centre of the ring
};

Box large_extent(const std::vector<Point>& points) {
    std::vector<Box> boxes;
    for (Point each : points)
        boxes.push_back({each, 0, 0});
    return around(boxes);
}

/// Puts the largest block down, single nodes to the left of it, the other blocks to the right.
class LargeArrangement {
public:
    LargeArrangement(const Network& network, const Wiring& wiring)
        : wiring_(wiring), blocks_(blocks_of(network, wiring)) {
        layout_.places.resize(network.nodes.size());
        layout_.on_ring.resize(network.nodes.size());
        std::ranges::stable_sort(blocks_, std::greater<>(), [](const Block& block) { return block.nodes.size(); });
    }

    LargeLayout arrange() {
        put_largest();
        for (const Block& block : std::span(blocks_).subspan(1))
            block.nodes.size() == 1 ? put_single(block.nodes.front()) : put(block, {right_ + apart, 0});
        return std::move(layout_);
    }

private:
    /// With its upper left corner there.
    void put(const Block& block, Point corner) {
        const Shape& shape = block.shapes.front();
        Box extent = large_extent(shape);
        for (std::size_t i = 0; i < shape.size(); ++i)
            layout_.places[block.nodes[i]] = shape[i] + corner - Point{extent.left(), extent.top()};
        right_ = corner.x + extent.width;
        height_ = std::max(height_, extent.height);
    }

    void put_largest() {
        const Block& block = blocks_.front();
        put(block, {});
        if (!block.round)
            return;
        layout_.ring = LargeRing{{right_ / 2, height_ / 2}, right_ / 2};
        for (auto node : block.nodes)
            layout_.on_ring[node] = true;
        middle_ = std::round(height_ / 2);
    }

    void put_single(std::size_t node) {
        auto wires =
            std::ranges::count_if(wiring_.neighbours(node), [&](auto other) { return layout_.on_ring[other]; });
        if (layout_.ring && !layout_.hub && 2 * static_cast<std::size_t>(wires) > blocks_.front().nodes.size()) {
            layout_.hub = node;
            layout_.places[node] = layout_.ring->centre;
            return;
        }
        auto rows = static_cast<std::size_t>(height_ - middle_) + 1;
        layout_.places[node] = {-apart - static_cast<double>(singles_ / rows),
                                middle_ + static_cast<double>(singles_ % rows)};
        ++singles_;
    }

    const Wiring& wiring_;
    std::vector<Block> blocks_;
    LargeLayout layout_;
    double right_ = 0, height_ = 0;
    double middle_ = 0; ///< the row of the first single node
    std::size_t singles_ = 0;
};

/// Leads wires through the lanes between rows and columns, and through the inside of a ring.
class LargeRouter {
public:
    LargeRouter(const LargeLayout& layout, const std::vector<DrawnNode>& nodes) : layout_(layout), nodes_(nodes) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Box& box = nodes[i].box;
            Point at = layout.places[i];
            rows_[at.y].add(at.x, box.top(), box.bottom());
            columns_[at.x].add(at.y, box.left(), box.right());
            if (layout.on_ring[i])
                ring_boxes_.push_back(box);
        }
        number(rows_);
        number(columns_);
        if (layout.ring)
            ring_ = around(ring_boxes_);
    }

    Path route(std::size_t a, std::size_t b) {
        if (is_inside(a) && is_inside(b))
            return within_ring(a, b);
        if (layout_.on_ring[a] || layout_.on_ring[b])
            return layout_.on_ring[a] ? from_ring(a, b) : reversed(from_ring(b, a));
        if (auto path = between_neighbours(a, b))
            return *path;
        return layout_.places[a].x <= layout_.places[b].x ? through_lanes(a, b) : reversed(through_lanes(b, a));
    }

private:
    struct Line {
        std::map<double, std::size_t> positions; ///< along it; their order
        double first, last;                      ///< borders of its boxes
        std::size_t number = 0;

        void add(double position, double least, double most) {
            first = positions.empty() ? least : std::min(first, least);
            last = positions.empty() ? most : std::max(last, most);
            positions.emplace(position, 0);
        }
    };
    using Lines = std::map<double, Line>;

    static void number(Lines& lines) {
        std::size_t count = 0;
        for (auto& [at, line] : lines) {
            line.number = count++;
            std::size_t order = 0;
            for (auto& [position, place] : line.positions)
                place = order++;
        }
    }

    static Path reversed(Path path) {
        std::ranges::reverse(path);
        return path;
    }

    const Box& box(std::size_t node) const { return nodes_[node].box; }
    const Line& row(std::size_t node) const { return rows_.at(layout_.places[node].y); }
    const Line& column(std::size_t node) const { return columns_.at(layout_.places[node].x); }
    bool is_inside(std::size_t node) const { return layout_.on_ring[node] || node == layout_.hub; }

    static bool follow(const Line& line, double one, double other) {
        auto a = line.positions.at(one), b = line.positions.at(other);
        return a + 1 == b || b + 1 == a;
    }

    /// A straight line in a row or column, or a line from one row to the next.
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

    /// Down from the one, below its row to the lane right of its column, along that, and below the row of the other.
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

    /// On the line from the centre of the ring through the node, so many cells outside of it.
    Point beside_ring(std::size_t node, double cells) const {
        return ring_.centre + (1 + cells / layout_.ring->radius) * (box(node).centre - ring_.centre);
    }

    Path within_ring(std::size_t a, std::size_t b) const {
        auto end = [&](std::size_t node) { return node == layout_.hub ? ring_.centre : beside_ring(node, -0.6); };
        Point from = end(a), to = end(b);
        Path path;
        if (a != layout_.hub)
            path = {way_out(box(a), box(a).centre, from), from};
        else
            path = {way_out(box(a), from, to)};
        if (b != layout_.hub)
            path.insert(path.end(), {to, way_out(box(b), box(b).centre, to)});
        else
            path.push_back(way_out(box(b), to, from));
        return path;
    }

    /// Around the ring to the side at which the other stands, then through the lanes.
    Path from_ring(std::size_t a, std::size_t b) const {
        Point outside = beside_ring(a, 0.7), to = box(b).centre, c = ring_.centre;
        bool leftward = to.x < c.x;
        Path path{way_out(box(a), box(a).centre, outside), outside};
        double across = ring_.width / 2, high = ring_.height / 2, reach = 1 + 0.75 / layout_.ring->radius;
        double angle = std::atan2((outside.y - c.y) / high, (outside.x - c.x) / across),
               goal = leftward ? std::numbers::pi : 0;
        if (leftward && angle < 0)
            goal = -goal;
        int steps = static_cast<int>(std::ceil(std::abs(goal - angle) * layout_.ring->radius));
        for (int i = 1; i <= steps; ++i) {
            double turn = angle + (goal - angle) * i / steps;
            path.push_back(c + Point{reach * across * std::cos(turn), reach * high * std::sin(turn)});
        }
        double x = path.back().x;
        if (leftward && std::abs(to.y - c.y) < 1 && column(b).number + 1 == first_ring_column())
            path.push_back({box(b).right(), path.back().y});
        else
            path.insert(path.end(), {{x, below(b, lane_start)}, {to.x, below(b, lane_start)}, {to.x, box(b).bottom()}});
        path.erase(std::unique(path.begin(), path.end()), path.end());
        return path;
    }

    std::size_t first_ring_column() const { return columns_.lower_bound(0)->second.number; }

    const LargeLayout& layout_;
    const std::vector<DrawnNode>& nodes_;
    Lines rows_, columns_;
    std::vector<Box> ring_boxes_;
    Box ring_;
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
