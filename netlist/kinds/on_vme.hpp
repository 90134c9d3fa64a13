#pragma once

#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "runtime/hardware/bus_memory.hpp"
#include "runtime/hardware/vme_bus.hpp"

namespace placedpar {

/// Joins a VMEbus and the device in one of its slots. The MachineNode of the device also derives from this struct.
struct OnVme {
    virtual ~OnVme() = default;

    hardware::BusProgram program = {};            ///< how a master's program uses the bus
    hardware::DualPortedMemory* memory = nullptr; ///< memory of a bus master; set by the bus
    hardware::BusSlave* slave = nullptr;          ///< the slave that answers for the device; set by the bus
};

/// Applies the fault leaves_the_bus() to the device. The fault has no effect on a device that never answers, such as an
/// adapter without a wire.
inline FaultEffects leave(const OnVme& device, const Fault& fault) {
    if (!device.slave)
        return {};
    const auto& absence = device.slave->leave(begin_of(fault), end_of(fault));
    return [&absence](FaultUse& use) { use.bus_errors = absence.unanswered; };
}

} // namespace placedpar
