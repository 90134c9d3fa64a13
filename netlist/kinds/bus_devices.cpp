#include "netlist/kinds/devices.hpp"

namespace placedpar {

DeviceKind bus_devices() {
    return {.name = "bus device",
            .noun = "a bus device",
            .about = "Link adapters, the VMEbus and bus masters.",
            .models = {{.name = "C011"}, {.name = "C012"}, {.name = "VME"}, {.name = "busmaster"}},
            .refusal = "link adapters, the VMEbus and bus masters come with the bus, which is not there yet"};
}

} // namespace placedpar
