#include "netlist/kinds/description.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/on_vme.hpp"
#include "runtime/hardware/link_timing.hpp"

namespace placedpar {

namespace {

struct AdapterNode final : MachineNode, OnVme {
    using MachineNode::MachineNode;
    FaultEffects suffer(const Fault& fault) override { return leave(*this, fault); }
};

} // namespace

DeviceKind link_adapter() {
    return {
        .name = "link adapter",
        .noun = "a link adapter",
        .about = "Joins a link and a bus by a register of one byte in each direction. It does not overlap "
                 "acknowledges.",
        .models = {{.name = "C011", .links = 1, .overlapped_acknowledge = false},
                   {.name = "C012", .links = 1, .overlapped_acknowledge = false}},
        .attributes = {{.value = description::integer(
                            "linkspeed",
                            {.unit = "bit/s", .by_default = hardware::LinkTiming::usual_speed, .least = 1, .most = 1e9},
                            "speed of the link, unless the connection states it"),
                        .decimal_suffixes = true,
                        .json_name = "link_bits_per_second"},
                       {.value = description::text("master", {.by_default = ""},
                                                   "master whose program uses the adapter; \"\": the only workstation "
                                                   "of the bus; if the bus has no workstation, its only master"),
                        .json_name = "master"}},
        .bus = BusRole::adapter,
        .faults = {leaves_the_bus()},
        .make = make_device<AdapterNode>,
        .drawing = {.frame = "#8a6d2b", .heading = "#f6ebcb", .legend = "link adapter"}};
}

} // namespace placedpar
