#include "netlist/kinds/devices.hpp"

namespace placedpar {

/// A bit takes 1.75 bit times to cross a C004 (C004 manual). For Graphviz it is not drawn: wires are
/// drawn from end to end, with the number of switches on their way.
DeviceKind crossbar() {
    return {.name = "c004",
            .noun = "a switch",
            .about = "A crossbar switch: its crosspoints connect its links to each other.",
            .models = {{.name = "C004", .links = 32}},
            .links = LinkRole::crosses,
            .crossing_delay = 175,
            .drawing = {.shape = Drawing::Shape::crossed_box,
                        .frame = "#4b6b3b",
                        .heading = "#dfeed6",
                        .legend = "crossbar switch"}};
}

} // namespace placedpar
