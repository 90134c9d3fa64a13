#include "picture/fault_marks.hpp"

#include "netlist/kinds/fault_kinds.hpp"

#include <algorithm>

namespace placedpar::picture {

namespace {

constexpr double text_height = 15;

/// Returns the boxes that a mark's text must not overlap.
std::vector<Box> boxes_to_avoid(const Picture& picture) {
    std::vector<Box> boxes;
    for (const DrawnNode& node : picture.nodes)
        boxes.push_back(grown(node.box, 2));
    for (const DrawnWire& wire : picture.wires) {
        for (const LinkLabel& label : wire.links)
            boxes.push_back(label.box);
        if (wire.channels)
            boxes.push_back(wire.channels->box);
    }
    return boxes;
}

/// Adds points on both sides of `at`, in the direction `aside` and opposite, up to the distance `farthest`, nearest
/// first.
void add_beside(Point at, Point aside, double farthest, std::vector<Point>& points) {
    for (double away = 0; away <= farthest; away += pitch)
        for (double side : {-1., 1.})
            points.push_back(at + (side * away) * aside);
}

/// Returns candidate places for a text: first on the wire near the middle of its longest line, then beside the wire.
std::vector<Point> places_at(const DrawnWire& wire) {
    const Path& path = *std::ranges::max_element(wire.spans, {}, [](const Path& each) {
        std::size_t line = longest_line(each);
        return distance(each[line], each[line + 1]);
    });
    Point from = path[longest_line(path)], to = path[longest_line(path) + 1];
    Point along = 1 / distance(from, to) * (to - from), aside{-along.y, along.x};
    std::vector<Point> points;
    for (double farthest : {0., 5 * pitch, 20 * pitch})
        for (double part : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8})
            add_beside(from + part * (to - from), aside, farthest, points);
    return points;
}

/// Returns candidate places for a text above and below the box, nearest first.
std::vector<Point> places_at(const Box& box) {
    std::vector<Point> points;
    for (double away = text_height; away <= 20 * pitch; away += pitch)
        for (double y : {box.top() - away, box.bottom() + away})
            for (double x : {0., -0.25, 0.25})
                points.push_back({box.centre.x + x * box.width, y});
    return points;
}

Box first_free(const std::vector<Point>& places, double width, const std::vector<Box>& taken) {
    auto is_free = [&](Point at) {
        return std::ranges::none_of(taken, [&](const Box& box) { return overlap(box, {at, width, text_height}); });
    };
    auto free = std::ranges::find_if(places, is_free);
    return {free == places.end() ? places.front() : *free, width, text_height};
}

} // namespace

std::vector<FaultMark> fault_marks(const Network& network, const Picture& picture) {
    std::vector<Box> taken = boxes_to_avoid(picture);
    std::vector<FaultMark> marks;
    auto add = [&](FaultMark mark, const std::vector<Point>& places) {
        mark.box = first_free(places, width_of(mark.text, fact_size) + 8, taken);
        taken.push_back(grown(mark.box, 1));
        marks.push_back(std::move(mark));
    };
    for (const Fault& fault : network.faults) {
        FaultMark mark{{}, {}, print_fault_shortly(fault), print_fault(fault, network.nodes), {}};
        if (fault.link < 0) {
            mark.node = fault.node;
            add(mark, places_at(picture.nodes[fault.node].box));
        }
        for (std::size_t wire = 0; wire < network.connections.size(); ++wire)
            if (strikes(fault, network.connections[wire]) && !picture.wires[wire].spans.empty()) {
                mark.wire = wire;
                add(mark, places_at(picture.wires[wire]));
            }
    }
    return marks;
}

} // namespace placedpar::picture
