#include "netlist/kinds/description.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/simulation.hpp"

namespace placedpar {

namespace {

AttributeDescription nanoseconds_of(std::string name, Time by_default, double least, std::string about) {
    std::string json_name = name + "_ns";
    return {.value = description::integer(
                std::move(name),
                {.unit = "ns",
                 .by_default = std::chrono::duration_cast<std::chrono::nanoseconds>(by_default).count(),
                 .least = least,
                 .most = 1e9},
                about),
            .json_name = std::move(json_name)};
}

std::vector<AttributeDescription> bus_attributes() {
    constexpr hardware::VmeTiming usual;
    return {{.value = description::text("arbiter", {.by_default = "PRI", .choices = {"PRI", "RRS", "SGL"}},
                                        "who gets the bus: the highest level, the levels in turn, or level 3 alone"),
             .json_name = "arbiter",
             .drawn = [](const Value& value) { return std::get<std::string>(value); }},
            nanoseconds_of("cycle", usual.word, 1, "of a word, 32 bits"),
            nanoseconds_of("bytecycle", usual.byte, 1, "of an access to a register"),
            nanoseconds_of("grant", usual.arbitration, 0, "from a request or a release to the grant"),
            nanoseconds_of("timeout", usual.time_out, 1, "until a bus error where nobody answers")};
}

AttributeDescription request_level() {
    return {.value = description::integer("level", {.by_default = 3, .least = 0, .most = 3}, "of its request")};
}

hardware::Arbitration arbitration_of(const Node& node) {
    const auto& arbiter = std::get<std::string>(node.attributes.at("arbiter"));
    return arbiter == "RRS"   ? hardware::Arbitration::round_robin
           : arbiter == "SGL" ? hardware::Arbitration::single_level
                              : hardware::Arbitration::priority;
}

Time nanoseconds_in(const Node& node, const char* attribute) {
    return std::chrono::nanoseconds{node.integer(attribute)};
}

hardware::VmeBus& make_vme(Simulation& simulation, const Node& node) {
    hardware::VmeTiming timing{.word = nanoseconds_in(node, "cycle"),
                               .byte = nanoseconds_in(node, "bytecycle"),
                               .arbitration = nanoseconds_in(node, "grant"),
                               .time_out = nanoseconds_in(node, "timeout")};
    return simulation.add<hardware::VmeBus>(node.name, arbitration_of(node), timing);
}

} // namespace

DeviceKind vme() {
    return {.name = "vme",
            .noun = "a bus",
            .about = "A VMEbus with slot[1] to slot[21], for workstations, bus masters and link adapters. Outputs that "
                     "are placed on it are broadcast to adapters.",
            .models = {{.name = "VME"}},
            .attributes = bus_attributes(),
            .bus = BusRole::is_bus,
            .make_bus = make_vme,
            .faults = {{.name = "hogged",
                        .about = "another master asks for the bus and does not let go of it",
                        .attributes = {fault_begins(), fault_must_end(), request_level()}}},
            .drawing = {.frame = "#8a4b2b", .heading = "#f6dccb", .legend = "bus"}};
}

} // namespace placedpar
