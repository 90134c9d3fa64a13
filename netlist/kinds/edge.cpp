#include "netlist/kinds/devices.hpp"

namespace placedpar {

DeviceKind edge() {
    return {.name = "edge",
            .noun = "an edge",
            .about = "The end of the network; nothing beyond it is simulated.",
            .models = {{.name = "edge"}},
            .links = LinkRole::edge,
            .drawing = {.shape = Drawing::Shape::ellipse, .frame = "#777777", .legend = "edge of the network"}};
}

} // namespace placedpar
