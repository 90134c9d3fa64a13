#include "runtime/hardware/workstation.hpp"
#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/devices.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/simulation.hpp"

namespace placedpar {

namespace {

/// As many links as are used, up to this.
constexpr int most_workstation_links = 1 << 20;

NodeExecutive make_on_bus(Simulation& simulation, const Node& node) {
    auto& workstation = simulation.add<hardware::Workstation>(node.name, node.integer("clock"));
    return {.executive = &workstation,
            .time_busy = [&workstation] { return workstation.time_busy(); },
            .has_link = [](hardware::Link&) {},
            .memory_taken_by_links = [] { return Time{0}; }};
}

} // namespace

DeviceKind workstation() {
    return {.name = "workstation",
            .noun = "a workstation",
            .about =
                "A host computer with as many links as are used; processes on it take no time, unless it is on a bus.",
            .models = {{.name = "workstation", .links = most_workstation_links}},
            .attributes = computer_attributes(),
            .kept = attributes_of_the_real_tool(),
            .runs_processes = true,
            .bus = BusRole::workstation,
            .bus_program = hardware::bus_programs::sun_3_280,
            .make_executive_on_bus = make_on_bus,
            .drawing = {.frame = "#7a6a3b", .heading = "#f3e9c9", .in_first_row = true, .legend = "workstation"}};
}

} // namespace placedpar
