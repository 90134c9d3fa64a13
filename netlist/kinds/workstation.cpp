#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/devices.hpp"

namespace placedpar {

namespace {

/// As many links as are used, up to this.
constexpr int most_workstation_links = 1 << 20;

} // namespace

DeviceKind workstation() {
    return {.name = "workstation",
            .noun = "a workstation",
            .about = "A host computer with as many links as are used; processes on it take no time.",
            .models = {{.name = "workstation", .links = most_workstation_links}},
            .attributes = computer_attributes(),
            .kept = attributes_of_the_real_tool(),
            .runs_processes = true,
            .drawing = {.frame = "#7a6a3b", .heading = "#f3e9c9", .in_first_row = true, .legend = "workstation"}};
}

} // namespace placedpar
