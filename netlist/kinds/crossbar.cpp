#include "runtime/hardware/crossbar.hpp"
#include "netlist/kinds/devices.hpp"
#include "runtime/simulation.hpp"

namespace placedpar {

namespace {

NodeExecutive make_crossbar(Simulation& simulation, const Node& node) {
    auto& crossbar = simulation.add<hardware::Crossbar>(node.name);
    return {.executive = &crossbar, .crossbar = &crossbar};
}

} // namespace

/// For Graphviz it is not drawn: wires are drawn from end to end, with the number of switches on their way.
DeviceKind crossbar() {
    return {.name = "c004",
            .noun = "a switch",
            .about =
                "A crossbar switch: its crosspoints connect its links to each other. Where its link `config` leads "
                "to a processor, a program sets them during the run.",
            .models = {{.name = "C004", .links = hardware::Crossbar::links}},
            .links = LinkRole::crosses,
            .logic = "csp.switch_logic",
            .make_executive = make_crossbar,
            .crossing_delay = hardware::Crossbar::crossing_delay,
            .drawing = {.shape = Drawing::Shape::crossed_box,
                        .frame = "#4b6b3b",
                        .heading = "#dfeed6",
                        .legend = "crossbar switch"}};
}

} // namespace placedpar
