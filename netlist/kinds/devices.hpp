#pragma once

#include "netlist/kinds/device_kind.hpp"

namespace placedpar {

/// These functions describe the devices that netlists can always use; Catalogue contains them. Each function is defined
/// in the file of its name.

/// Describes transputers, modules with a transputer such as the B404, and the word `processor`, which needs the
/// attribute `type`. The names of transputers may be in upper or lower case.
DeviceKind transputers();
/// Describes a host computer with any number of links. Its processes take virtual time only if it is attached to a bus.
DeviceKind workstation();
/// Describes the C004, a crossbar switch. A wire through a C004 becomes a connection of the processors at its ends.
DeviceKind crossbar();
/// Describes an edge: the place where the network ends.
DeviceKind edge();
/// Describes a VMEbus.
DeviceKind vme();
/// Describes the link adapters C011 and C012.
DeviceKind link_adapter();
/// Describes a transputer board that is a master on a VMEbus, such as the BBK-V2.
DeviceKind bus_master();
/// Describes a core of this computer. In a native run, which simulates no transputers, each thread is executed on a
/// core.
DeviceKind core();
/// Describes the memory through which cores communicate.
DeviceKind shared_memory();

/// Lists all devices above.
inline constexpr DeviceKind (*known_devices[])() = {transputers,  workstation, crossbar, edge,         vme,
                                                    link_adapter, bus_master,  core,     shared_memory};

} // namespace placedpar
