#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/on_vme.hpp"
#include "netlist/kinds/transputer_node.hpp"
#include "runtime/hardware/bus_programs.hpp"

namespace placedpar {

namespace {

class BusMasterNode final : public TransputerNode, public OnVme {
public:
    BusMasterNode(MachineParts& parts, std::size_t node) : TransputerNode(parts, node) {
        program = hardware::bus_programs::bbk_v2;
    }

    FaultEffects suffer(const Fault& fault) override {
        return leaves_the_bus(fault) ? leave(*this, fault) : TransputerNode::suffer(fault);
    }
};

} // namespace

/// Describes a transputer in a slot of a VMEbus. In addition to the attributes and faults of a transputer, it has one
/// more attribute and the fault `absent`.
DeviceKind bus_master() {
    DeviceKind kind = transputers();
    kind.name = "bus master";
    kind.noun = "a bus master";
    kind.about = "A T800 with 2 Mbyte of dual-ported memory, which it shares with a bus: the BBK-V2.";
    kind.models.clear();
    for (const char* name : {"busmaster", "BBKV2"})
        kind.models.push_back({.name = name, .links = 4, .attributes = {{"memory", 2 * megabyte}}});
    kind.attributes.push_back(
        {.value = description::integer("conversion",
                                       {.unit = "cycles",
                                        .by_default = static_cast<std::int64_t>(hardware::bus_programs::conversion),
                                        .least = 0,
                                        .most = 1000},
                                       "cycles to convert the byte order of a word exchanged with a workstation"),
         .json_name = "conversion_cycles"});
    kind.faults.push_back(leaves_the_bus());
    kind.bus = BusRole::bus_master;
    kind.make = make_device<BusMasterNode>;
    kind.drawing = {.frame = "#6b3b6b", .heading = "#ecd5ec", .legend = "bus master"};
    return kind;
}

} // namespace placedpar
