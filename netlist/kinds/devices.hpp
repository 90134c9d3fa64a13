#pragma once

#include "netlist/kinds/device_kind.hpp"

namespace placedpar {

/// These functions describe the devices that every catalogue has. Each function is defined in the file of its name.

/// Describes transputers, TRAM modules such as the B404, and `processor`, which needs the attribute `type`. The names
/// of transputers may be in upper or lower case.
DeviceKind transputers();
/// Describes a host computer with any number of links. Processes on it take no time unless it is on a bus.
DeviceKind workstation();
/// Describes the C004. Connections through it are resolved to the processors at their ends.
DeviceKind crossbar();
/// Describes an edge: the place where the network ends.
DeviceKind edge();
/// Describes a VMEbus.
DeviceKind vme();
/// Describes the link adapters C011 and C012.
DeviceKind link_adapter();
/// Describes a transputer on a bus, such as the BBK-V2.
DeviceKind bus_master();
/// Describes a core of this computer, which runs a thread of a native run.
DeviceKind core();
/// Describes the memory through which cores communicate.
DeviceKind shared_memory();

/// Lists all devices above.
inline constexpr DeviceKind (*known_devices[])() = {transputers,  workstation, crossbar, edge,         vme,
                                                    link_adapter, bus_master,  core,     shared_memory};

} // namespace placedpar
