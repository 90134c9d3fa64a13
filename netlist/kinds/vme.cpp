#include "netlist/kinds/vme.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "runtime/hardware/vme_bus.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    return {{.value = description::text(
                 "arbiter", {.by_default = "PRI", .choices = {"PRI", "RRS", "SGL"}},
                 "arbitration: PRI grants the highest requested level, RRS the levels in turn, SGL level 3 only"),
             .json_name = "arbiter",
             .drawn = [](const Value& value) { return std::get<std::string>(value); }},
            nanoseconds_of("cycle", usual.word, 1, "time to transfer a word of 32 bits"),
            nanoseconds_of("bytecycle", usual.byte, 1, "time of an access to a register"),
            nanoseconds_of("grant", usual.arbitration, 0, "time from a request or a release to the grant"),
            nanoseconds_of("timeout", usual.time_out, 1,
                           "time after which an access without an answer ends in a bus error")};
}

AttributeDescription request_level() {
    return {.value = description::integer("level", {.by_default = 3, .least = 0, .most = 3}, "level of the request")};
}

/// Returns the reason why the fault `hogged` (a further master that holds the bus for a time) is impossible: the
/// arbiter does not have the fault's request level, or no slot is free. Returns "" if the fault is possible.
std::string why_not_hogged(const Network& network, const Fault& hog) {
    const Node& bus = network.nodes[hog.node];
    auto others = std::ranges::count_if(network.faults,
                                        [&](const Fault& each) { return each.link < 0 && each.node == hog.node; });
    if (has_single_level(bus) && hog.integer("level") != 3)
        return fmt::format("\"{}\" has the arbiter SGL, which has only level 3", bus.name);
    if (free_slot(network, hog.node, static_cast<std::size_t>(others)) < 1)
        return fmt::format("no slot of \"{}\" is free for the master that hogs it", bus.name);
    return "";
}

/// Returns the names of the tracks in a trace: the bus, its masters, then the masters that faults add.
std::vector<std::string> bus_tracks(const Network& network, std::size_t node) {
    const std::string& bus = network.nodes[node].name;
    std::vector<std::string> names{bus};
    for (const BusAttachment& each : network.attachments)
        if (each.bus == node && network.nodes[each.node].kind->is_master())
            names.push_back(bus + " <- " + network.nodes[each.node].name);
    std::size_t hogs = 0;
    for (const Fault& each : network.faults)
        if (each.link < 0 && each.node == node)
            names.push_back(fmt::format("{} <- slot {}", bus, free_slot(network, node, hogs++)));
    return names;
}

} // namespace

DeviceKind vme() {
    return {.name = "vme",
            .noun = "a bus",
            .about = "A VMEbus with slot[1] to slot[21], for workstations, bus masters and link adapters. Outputs that "
                     "are placed on it are broadcast to adapters.",
            .models = {{.name = "VME"}},
            .attributes = bus_attributes(),
            .medium = Medium{.slots = vme_slots, .broadcasts = true, .takes = can_be_attached, .ways = ways_over_bus},
            .faults = {{.name = "hogged",
                        .about = "another master requests the bus and does not release it",
                        .attributes = {fault_begins(), fault_must_end(), request_level()},
                        .why_not = why_not_hogged}},
            .tracks = bus_tracks,
            .make = make_vme,
            .drawing = {.frame = "#8a4b2b", .heading = "#f6dccb", .legend = "bus"}};
}

} // namespace placedpar
