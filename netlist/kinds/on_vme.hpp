#pragma once

#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "runtime/hardware/bus_memory.hpp"
#include "runtime/hardware/vme_bus.hpp"

namespace placedpar {

/// Tells a VMEbus what is in one of its slots: a MachineNode there is this, too.
struct OnVme {
    virtual ~OnVme() = default;

    hardware::BusProgram program = {};            ///< of a master
    hardware::DualPortedMemory* memory = nullptr; ///< of a bus master; given by the bus
    hardware::BusSlave* slave = nullptr;          ///< what answers for it; given by the bus
};

/// The device has the fault leaves_the_bus(). One that never answers, as an adapter without a wire, does as before.
inline FaultEffects leave(const OnVme& device, const Fault& fault) {
    if (!device.slave)
        return {};
    const auto& absence = device.slave->leave(begin_of(fault), end_of(fault));
    return [&absence](FaultUse& use) { use.bus_errors = absence.unanswered; };
}

} // namespace placedpar
