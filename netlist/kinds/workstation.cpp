#include "runtime/hardware/workstation.hpp"
#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/on_vme.hpp"
#include "runtime/hardware/bus_programs.hpp"

namespace placedpar {

namespace {

/// Limits the number of links of a workstation, which has as many links as the netlist uses.
constexpr int most_workstation_links = 1 << 20;

class WorkstationNode : public MachineNode, public OnVme {
public:
    WorkstationNode(MachineParts& parts, std::size_t index) : MachineNode(parts, index) {
        program = hardware::bus_programs::sun_3_280;
        if (is_on_bus(network(), index))
            computer_ = &simulation().add<hardware::Workstation>(node().name, node().integer("clock"));
    }

    Executive* executive() override { return computer_; }
    void report(MachineUse& use) const override {
        if (computer_)
            use.processors.push_back({node().name, node().type, computer_->time_busy(), Time{0}});
    }

private:
    hardware::Workstation* computer_ =
        nullptr; ///< null if the workstation is not attached to a bus; its processes then take no time
};

} // namespace

DeviceKind workstation() {
    return {.name = "workstation",
            .noun = "a workstation",
            .about = "A host computer, which has as many links as the netlist uses; its processes take no time, unless "
                     "the computer is on a bus.",
            .models = {{.name = "workstation", .links = most_workstation_links}},
            .attributes = computer_attributes(),
            .kept = attributes_of_the_real_tool(),
            .executes = Execution::in_time_on_a_bus,
            .bus = BusRole::workstation,
            .make = make_device<WorkstationNode>,
            .drawing = {.frame = "#7a6a3b", .heading = "#f3e9c9", .in_first_row = true, .legend = "workstation"}};
}

} // namespace placedpar
