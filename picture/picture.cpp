#include "picture/picture.hpp"

#include "picture/arrange.hpp"
#include "picture/large.hpp"

#include <tuple>

namespace placedpar::picture {

Picture draw(const Network& network, const std::vector<Span>& spans, const std::vector<Point>& places) {
    Picture picture;
    if (network.nodes.size() >= large_network) {
        std::tie(picture.nodes, picture.wires) = draw_large(network, spans);
        return picture;
    }
    picture.nodes = draw_nodes(network, spans, places.empty() ? arrange(network, Wiring(network)) : places);
    picture.wires = draw_wires(network, spans, picture.nodes);
    return picture;
}

Box extent_of(const Picture& picture) {
    std::vector<Box> boxes;
    for (const DrawnNode& node : picture.nodes)
        boxes.push_back(node.box);
    for (const DrawnWire& wire : picture.wires) {
        for (const Path& path : wire.spans)
            for (Point p : path)
                boxes.push_back({p, 0, 0});
        for (const LinkLabel& label : wire.links)
            boxes.push_back(label.box);
    }
    return around(boxes);
}

} // namespace placedpar::picture
