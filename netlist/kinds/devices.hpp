#pragma once

#include "netlist/kinds/device_kind.hpp"

namespace placedpar {

/// The devices that every netlist can declare, each in a file of its name.

/// Transputers by name in upper and lower case, TRAM modules by B-number, and `processor`, which needs a type.
DeviceKind transputer();
/// A host computer: any number of links; processes on it run in no time.
DeviceKind workstation();
/// The C004: connections through it are resolved to the processors at their ends.
DeviceKind crossbar();
/// Where the network ends.
DeviceKind edge();
/// Link adapters, the VMEbus and bus masters: known by name, refused.
DeviceKind bus_devices();

} // namespace placedpar
