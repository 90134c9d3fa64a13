#pragma once

#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "runtime/hardware/bus_memory.hpp"
#include "runtime/hardware/vme_bus.hpp"

namespace placedpar {

/// Holds what a simulated VMEbus and a device in one of its slots need from each other. The class of the device derives
/// from MachineNode and from this struct.
struct OnVme {
    virtual ~OnVme() = default;

    hardware::BusProgram program = {}; ///< for a master: how its program uses the bus
    hardware::DualPortedMemory* memory =
        nullptr; ///< for a bus master, a transputer whose memory other masters can access: this memory; set by the bus
    hardware::BusSlave* slave = nullptr; ///< the part of the bus that answers accesses to the device; set by the bus;
                                         ///< null if the device never answers
};

/// Gives a device the fault `absent`: from its beginning to its end, the device answers no access. The fault has no
/// effect on a device that never answers, such as a link adapter without a wire.
inline FaultEffects leave(const OnVme& device, const Fault& fault) {
    if (!device.slave)
        return {};
    const auto& absence = device.slave->leave(begin_of(fault), end_of(fault));
    return [&absence](FaultUse& use) { use.bus_errors = absence.unanswered; };
}

} // namespace placedpar
