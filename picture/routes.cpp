#include "picture/routes.hpp"

#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace placedpar::picture {

namespace {

constexpr double port_pitch = 2 * pitch, parallel_gap = 12, margin = 12 * pitch;
constexpr double count_height = 14;

std::vector<Box> boxes_of(const std::vector<DrawnNode>& nodes) {
    std::vector<Box> boxes;
    for (const DrawnNode& node : nodes)
        boxes.push_back(node.box);
    return boxes;
}

/// The sides of a box at which a wire may leave.
struct Sides {
    bool right = true, below = true, left = true, above = true;
};

void add_ports(std::vector<Port>& ports, Point middle, Point along, Point outward, double length) {
    for (double offset = 0; offset + pitch <= length / 2; offset += port_pitch)
        for (double sign : {1., -1.})
            if (offset > 0 || sign > 0)
                ports.push_back({middle + sign * offset * along, outward});
}

std::vector<Port> ports_of(const Box& box, const Sides& sides) {
    std::vector<Port> ports;
    Point c = box.centre;
    if (sides.right)
        add_ports(ports, {box.right(), c.y}, {0, 1}, {1, 0}, box.height);
    if (sides.below)
        add_ports(ports, {c.x, box.bottom()}, {1, 0}, {0, 1}, box.width);
    if (sides.left)
        add_ports(ports, {box.left(), c.y}, {0, 1}, {-1, 0}, box.height);
    if (sides.above)
        add_ports(ports, {c.x, box.top()}, {1, 0}, {0, -1}, box.width);
    return ports;
}

/// Returns the middle of the range that two boxes share along an axis, rounded to a multiple of the pitch, and half of
/// the range's length.
std::pair<double, double> common_range(double from, double to, double other_from, double other_to) {
    double least = std::max(from, other_from), most = std::min(to, other_to);
    return {std::round((least + most) / 2 / pitch) * pitch, (most - least) / 2};
}

class Router {
public:
    Router(const Network& network, const std::vector<Span>& spans, const std::vector<DrawnNode>& nodes)
        : n_(network), spans_(spans), boxes_(boxes_of(nodes)), wires_(network.connections.size()), room_(boxes_),
          paths_(spans.size()) {}

    std::vector<DrawnWire> draw() {
        for (std::size_t i = 0; i < spans_.size(); ++i)
            draw_straight(i);
        label();
        draw_around();
        label();
        for (std::size_t i = 0; i < spans_.size(); ++i)
            wires_[spans_[i].connection].spans.push_back(paths_[i]);
        return std::move(wires_);
    }

private:
    const Box& box_of(const LinkEnd& end) const { return boxes_[end.node]; }

    void draw_straight(std::size_t index) {
        const Span& span = spans_[index];
        Path path = level(span);
        if (path.empty())
            path = upright(span);
        if (path.empty())
            path = slanting(span);
        keep(index, path);
    }

    void keep(std::size_t index, const Path& path) {
        paths_[index] = path;
        room_.add_wire(spans_[index].connection, path);
        if (path.empty())
            return;
        used_.emplace(path.front().x, path.front().y);
        used_.emplace(path.back().x, path.back().y);
    }

    Path level(const Span& span) const {
        const Box &a = box_of(span.from), &b = box_of(span.to);
        auto [middle, reach] = common_range(a.top(), a.bottom(), b.top(), b.bottom());
        bool onward = a.centre.x < b.centre.x;
        return first_clear(span, middle, reach, [&](double y) -> Path {
            return {{onward ? a.right() : a.left(), y}, {onward ? b.left() : b.right(), y}};
        });
    }

    Path upright(const Span& span) const {
        const Box &a = box_of(span.from), &b = box_of(span.to);
        auto [middle, reach] = common_range(a.left(), a.right(), b.left(), b.right());
        bool onward = a.centre.y < b.centre.y;
        return first_clear(span, middle, reach, [&](double x) -> Path {
            return {{x, onward ? a.bottom() : a.top()}, {x, onward ? b.top() : b.bottom()}};
        });
    }

    /// Returns the first free straight line between two boxes, or an empty path. The lines are tried from the middle of
    /// the boxes' shared range outwards.
    template <class LineAt>
    Path first_clear(const Span& span, double middle, double reach, LineAt line_at) const {
        for (double offset = 0; offset + pitch <= reach; offset += port_pitch)
            for (double sign : {1., -1.})
                if (Path path = line_at(middle + sign * offset); is_clear(path, span) && is_unused(path))
                    return path;
        return {};
    }

    bool is_clear(const Path& path, const Span& span) const {
        for (std::size_t i = 0; i < boxes_.size(); ++i)
            if (i != span.from.node && i != span.to.node && crosses(grown(boxes_[i], 4), path[0], path[1]))
                return false;
        return true;
    }

    bool is_unused(const Path& path) const {
        return !used_.contains({path[0].x, path[0].y}) && !used_.contains({path[1].x, path[1].y});
    }

    Path slanting(const Span& span) const {
        const Box &a = box_of(span.from), &b = box_of(span.to);
        Point way = b.centre - a.centre, aside{-way.y / distance({}, way), way.x / distance({}, way)};
        for (double offset = 0; offset <= 2 * parallel_gap; offset += parallel_gap)
            for (double sign : {1., -1.}) {
                Point move = sign * offset * aside;
                Path path{way_out(a, a.centre + move, b.centre + move), way_out(b, b.centre + move, a.centre + move)};
                if (is_clear(path, span) && is_unused(path))
                    return path;
            }
        return {};
    }

    void draw_around() {
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < spans_.size(); ++i)
            if (paths_[i].empty())
                left.push_back(i);
        if (left.empty())
            return;
        double more = pitch * static_cast<double>(std::min<std::size_t>(left.size(), 40));
        Raster raster(grown(around(boxes_), margin + more), boxes_);
        for (const Path& path : paths_)
            raster.add(path);
        for (const Box& label : labels_)
            raster.block(grown(label, pitch / 2));
        auto length = [&](std::size_t i) {
            return distance(box_of(spans_[i].from).centre, box_of(spans_[i].to).centre);
        };
        std::ranges::stable_sort(left, {}, length);
        for (auto index : left)
            draw_around(index, raster);
    }

    /// Draws a wire around boxes. If no path is found, the wire is a straight line over everything between its ends.
    void draw_around(std::size_t index, Raster& raster) {
        const Span& span = spans_[index];
        const Box &a = box_of(span.from), &b = box_of(span.to);
        auto [from, to] = sides_of(span);
        auto path = raster.find(ports_of(a, from), ports_of(b, to));
        if (!path)
            path = raster.find(ports_of(a, {}), ports_of(b, {}));
        if (!path)
            path = {way_out(a, a.centre, b.centre), way_out(b, b.centre, a.centre)};
        raster.add(*path);
        keep(index, *path);
    }

    std::pair<Sides, Sides> sides_of(const Span& span) const {
        const Box &a = box_of(span.from), &b = box_of(span.to);
        bool row = a.centre.y == b.centre.y && is_outmost(span, &Point::y, &Point::x);
        bool column = a.centre.x == b.centre.x && is_outmost(span, &Point::x, &Point::y);
        if (!row && !column)
            return {};
        bool onward = row ? a.centre.x < b.centre.x : a.centre.y < b.centre.y;
        Sides last{row, column, false, false}, first{false, false, row, column};
        return onward ? std::pair(first, last) : std::pair(last, first);
    }

    /// Returns whether the two nodes are the first and the last of a row or column of their array.
    bool is_outmost(const Span& span, double Point::*same, double Point::*other) const {
        auto base = base_name(n_.nodes[span.from.node].name);
        Point a = box_of(span.from).centre, b = box_of(span.to).centre;
        double least = std::min(a.*other, b.*other), most = std::max(a.*other, b.*other);
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            Point c = boxes_[i].centre;
            if (base_name(n_.nodes[i].name) == base && c.*same == a.*same && (c.*other < least || c.*other > most))
                return false;
        }
        return base_name(n_.nodes[span.to.node].name) == base;
    }

    /// Adds the labels with link numbers and numbers of channels to the wires drawn since the last call.
    void label() {
        auto due = [&](std::size_t i) { return !paths_[i].empty() && labelled_.insert(i).second; };
        std::vector<std::size_t> now;
        for (std::size_t i = 0; i < spans_.size(); ++i)
            if (due(i))
                now.push_back(i);
        for (auto index : now)
            label_ends(index);
        auto counts = channels_carried();
        for (auto index : now)
            label_channels(index, counts[spans_[index].connection]);
    }

    void label_ends(std::size_t index) {
        const Span& span = spans_[index];
        Path path = paths_[index];
        label_end(span.connection, span.from_label, path);
        std::ranges::reverse(path);
        label_end(span.connection, span.to_label, path);
    }

    void label_end(std::size_t wire, const std::string& text, const Path& path) {
        if (text.empty())
            return;
        if (auto box = room_.beside_start(wire, path, width_of(text, number_size) + 1, number_size)) {
            wires_[wire].links.push_back({*box, text});
            labels_.push_back(*box);
        }
    }

    struct Carried {
        std::size_t from_a = 0, from_b = 0;
    };

    std::vector<Carried> channels_carried() const {
        std::vector<Carried> carried(n_.connections.size());
        for (const NetworkChannel& channel : n_.channels)
            for (const RouteHop& hop : channel.placement.route)
                ++(hop.from_a_to_b ? carried[hop.connection].from_a : carried[hop.connection].from_b);
        return carried;
    }

    void label_channels(std::size_t index, const Carried& carried) {
        const Path& path = paths_[index];
        std::size_t wire = spans_[index].connection;
        if (wires_[wire].channels || carried.from_a + carried.from_b == 0)
            return;
        Point from = path[longest_line(path)], to = path[longest_line(path) + 1];
        bool upright = std::abs(to.y - from.y) > std::abs(to.x - from.x);
        bool onward = upright ? from.y < to.y : from.x < to.x;
        ChannelCount count{{}, carried.from_a, carried.from_b, upright};
        if (!onward)
            std::swap(count.onward, count.back);
        if (auto box = room_.on_middle(wire, path, width_of_count(count.onward, count.back), count_height)) {
            count.box = *box;
            wires_[wire].channels = count;
            labels_.push_back(*box);
        }
    }

    const Network& n_;
    const std::vector<Span>& spans_;
    std::vector<Box> boxes_;
    std::vector<DrawnWire> wires_;
    LabelRoom room_;
    std::vector<Path> paths_;
    std::set<std::pair<double, double>> used_;
    std::set<std::size_t> labelled_;
    std::vector<Box> labels_;
};

} // namespace

double width_of_count(std::size_t onward, std::size_t back) {
    double width = 8 + (onward > 0 && back > 0 ? 6 : 0);
    for (auto each : {onward, back})
        if (each > 0)
            width += digit_width * static_cast<double>(fmt::format("{}", each).size()) + arrow_width;
    return width;
}

std::vector<DrawnWire> draw_wires(const Network& network, const std::vector<Span>& spans,
                                  const std::vector<DrawnNode>& nodes) {
    return Router(network, spans, nodes).draw();
}

} // namespace placedpar::picture
