#include "netlist/kinds/booted_node.hpp"
#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/memory_access.hpp"
#include "netlist/kinds/transputer_node.hpp"
#include "runtime/hardware/router.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace placedpar {

namespace {

/// Returns true for the T805, T801 and T800.
bool has_floating_point_unit(const std::string& chip) { return chip.starts_with("T80"); }

DeviceModel chip(std::string name, std::int64_t memory_bytes, int links, bool overlapped_acknowledge) {
    const bool floating_point_unit = has_floating_point_unit(name);
    return {.name = std::move(name),
            .links = links,
            .attributes = {{"memory", memory_bytes}},
            .overlapped_acknowledge = overlapped_acknowledge,
            .floating_point_unit = floating_point_unit};
}

/// Returns the bare chips with their internal memory. The M212 has two links for the network; two more links lead to
/// its disk ports.
///
/// Links with overlapped acknowledge send the acknowledge of a byte while the byte arrives. The databook says that the
/// T800, T805 and T425 do this, and that the T414 does not. For the other chips we assume what is true for chips of
/// their generation: the T801, T400, T222 and T225 do this; the T212 and M212 do not.
std::vector<DeviceModel> chips() {
    constexpr bool overlapped = true, separate = false;
    return {chip("T805", 4 * kilobyte, 4, overlapped), chip("T801", 4 * kilobyte, 4, overlapped),
            chip("T800", 4 * kilobyte, 4, overlapped), chip("T425", 4 * kilobyte, 4, overlapped),
            chip("T414", 2 * kilobyte, 4, separate),   chip("T400", 2 * kilobyte, 2, overlapped),
            chip("T225", 4 * kilobyte, 4, overlapped), chip("T222", 4 * kilobyte, 4, overlapped),
            chip("T212", 2 * kilobyte, 4, separate),   chip("M212", 2 * kilobyte, 2, separate)};
}

/// Returns the model with its name in lower case, such as t800. The type stays in upper case, T800.
DeviceModel in_lower_case(DeviceModel model) {
    model.type = model.name;
    model.name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(model.name[0])));
    return model;
}

/// Describes a module with a transputer: a TRAM, or a transputer on an evaluation board.
struct Module {
    std::string name, chip;
    std::int64_t memory_bytes;
};

/// Returns the modules with their memory. Their names are the INMOS part numbers in the toolset's files `boards.inc`
/// and `trams.inc`. The modules ran at 20 MHz, the default here.
std::vector<Module> modules() {
    return {{"B002", "T414", 2 * megabyte},    {"B003", "T414", 256 * kilobyte}, {"B004", "T414", 2 * megabyte},
            {"B006", "T212", 8 * kilobyte},    {"B010", "T414", 1 * megabyte},   {"B011", "T800", 2 * megabyte},
            {"B401", "T800", 32 * kilobyte},   {"B402", "T212", 8 * kilobyte},   {"B403", "T800", 1 * megabyte},
            {"B404", "T800", 2 * megabyte},    {"B405", "T800", 8 * megabyte},   {"B407", "T222", 64 * kilobyte},
            {"B408", "T800", 1280 * kilobyte}, {"B410", "T801", 160 * kilobyte}, {"B411", "T800", 1 * megabyte},
            {"B416", "T222", 64 * kilobyte},   {"B417", "T800", 4 * megabyte},   {"B419", "T800", 2 * megabyte},
            {"B422", "T222", 64 * kilobyte},   {"B426", "T800", 4 * megabyte},   {"B427", "T805", 8 * megabyte},
            {"B428", "T805", 2 * megabyte},    {"B430", "T222", 64 * kilobyte}};
}

DeviceModel carrying(std::string name, std::int64_t memory_bytes, DeviceModel chip) {
    chip.type = chip.name;
    chip.name = std::move(name);
    chip.attributes["memory"] = memory_bytes;
    return chip;
}

/// Returns whether a chip differs in word length from the usual chip of a module. Modules were also sold with other
/// chips of the usual word length: the B403_T414, for example, is a B403 with a T414.
bool has_other_word_length(const DeviceModel& chip, const std::string& usual) {
    return has_short_words(chip.name) != has_short_words(usual);
}

/// Returns the chip, under its name in upper and in lower case, and the modules that carry it.
std::vector<DeviceModel> models_with(const DeviceModel& chip) {
    std::vector<DeviceModel> models{chip, in_lower_case(chip)};
    for (const auto& [name, usual, memory_bytes] : modules()) {
        if (usual == chip.name)
            models.push_back(carrying(name, memory_bytes, chip));
        if (!has_other_word_length(chip, usual))
            models.push_back(carrying(name + "_" + chip.name, memory_bytes, chip));
    }
    return models;
}

std::vector<DeviceModel> transputer_models() {
    std::vector<DeviceModel> models;
    for (const char* name : {"processor", "PROCESSOR"})
        models.push_back({.name = name, .links = 4, .needs_type = true});
    for (const DeviceModel& each : chips())
        std::ranges::move(models_with(each), std::back_inserter(models));
    return models;
}

std::vector<AttributeDescription> attributes_of_booted_programs() {
    return {{.value = description::integer(
                 "hosttime", {.unit = "ns", .by_default = 0, .least = 0, .most = 1e12},
                 "time that the host at this processor takes to answer a request of the booted program"),
             .json_name = "host_time_ns"},
            {.value = description::integer(
                 "wraps", {.by_default = 0, .least = 0, .most = 1},
                 "1: addresses outside the memory are taken modulo the memory's size, as on boards; 0: the processor "
                 "stops if the booted program uses such an address, except in the instructions lb, sb, ldnl and stnl"),
             .json_name = "memory_wraps"}};
}

std::vector<AttributeDescription> transputer_attributes() {
    auto attributes = computer_attributes();
    for (auto& attribute : attributes)
        if (attribute.value.name == "clock")
            attribute.drawn = megahertz;
    attributes.push_back(
        {.value = description::integer("memorycycles", {.unit = "cycles", .by_default = 0, .least = 0, .most = 1000},
                                       "cycles of an access to a word of external memory, which holds the messages and "
                                       "all code and data that are not on the chip; 0 stands for 2 cycles for a T2 or "
                                       "T801, 3 cycles for other types, and 1 cycle if `memory` fits in the chip's 4K"),
         .json_name = "memory_access_cycles"});
    attributes.push_back(
        {.value = description::integer("switching",
                                       {.unit = "cycles",
                                        .by_default = static_cast<std::int64_t>(hardware::Processor::usual_switching),
                                        .least = 0,
                                        .most = 1000},
                                       "cycles to switch from one process to the next, besides the cycles of the "
                                       "instruction by which the process gives up the processor"),
         .json_name = "switching_cycles"});
    std::ranges::move(attributes_of_booted_programs(), std::back_inserter(attributes));
    attributes.push_back(
        {.value = description::integer("routecost", {.by_default = 1, .least = 0, .most = 1e9},
                                       "cost of routing a channel through this processor; the cheapest route is "
                                       "chosen"),
         .json_name = "route_cost"});
    attributes.push_back(
        {.value = description::integer("linkquota", {.unit = "links", .by_default = 4, .least = 0, .most = 1e6},
                                       "number of wired links, lowest first, that channels through the processor may "
                                       "use; 0: none"),
         .json_name = "link_quota"});
    attributes.push_back(
        {.value = description::integer("router_priority", {.by_default = 0, .least = 0, .most = 1},
                                       "priority of the processes that send and receive packets: HIGH pre-empts "
                                       "computing processes, LOW waits for its turn"),
         .json_name = "router_priority"});
    attributes.push_back(
        {.value = description::integer("router_cycles",
                                       {.unit = "cycles",
                                        .by_default = static_cast<std::int64_t>(hardware::RouterCosts{}.handling),
                                        .least = 0,
                                        .most = 1e9},
                                       "cycles to send or receive a packet, besides the cycles of the instruction"),
         .json_name = "router_cycles"});
    return attributes;
}

/// Returns the attributes that only INMOS's configurer icconf uses.
std::vector<std::string> kept_attributes() {
    auto kept = attributes_of_the_real_tool();
    std::erase(kept, "linkquota");
    return kept;
}

hardware::Memory memory_of(const Node& node) {
    return {.access = access_time(node), .bytes_in_a_word = has_short_words(node.type) ? 2 : 4};
}

/// Returns an error if a transputer of 16 bits has more memory than it can address (IMS T225 data sheet: 64 Kbytes);
/// otherwise "".
std::string what_it_cannot_address(const Node& node) {
    constexpr std::int64_t most = 64 * kilobyte;
    if (!has_short_words(node.type) || node.integer("memory") <= most)
        return "";
    return fmt::format("\"{}\" has {} bytes of memory; a {} addresses at most 64K", node.name, node.integer("memory"),
                       node.type);
}

/// Makes a transputer that executes machine code, or a transputer that executes processes in C++.
std::unique_ptr<MachineNode> make_transputer(MachineParts& parts, std::size_t node) {
    if (parts.network.nodes[node].runs_own_code)
        return std::make_unique<BootedNode>(parts, node);
    return std::make_unique<TransputerNode>(parts, node);
}

} // namespace

TransputerNode::TransputerNode(MachineParts& parts, std::size_t index)
    : MachineNode(parts, index),
      processor_(simulation().add<hardware::Processor>(node().name, node().integer("clock"),
                                                       Cycles{node().integer("channelcall")}, memory_of(node()),
                                                       Cycles{node().integer("switching")})) {}

hardware::RouterCosts TransputerNode::router_costs() const {
    return {.priority = node().integer("router_priority") == 0 ? Priority::high : Priority::low,
            .handling = Cycles{node().integer("router_cycles")}};
}

FaultEffects TransputerNode::suffer(const Fault& halts) {
    processor_.halt_at(begin_of(halts));
    return {};
}

void TransputerNode::report(MachineUse& use) const {
    ProcessorUse row{node().name, node().type, processor_.time_busy(), processor_.memory_taken_by_links()};
    if (const hardware::Router* router = router_if_any()) {
        row.packets_passed_on = router->packets_passed_on();
        auto cycles = static_cast<std::int64_t>(router->cycles_of_passing_on());
        row.passing_on = cycles == 0 ? Time{0} : duration_of(cycles, node().integer("clock"));
    }
    use.processors.push_back(std::move(row));
}

DeviceKind transputers() {
    return {.name = "processor",
            .noun = "a processor",
            .about = "A transputer, bare or on a module; B403_T414 is a B403 with a T414.",
            .models = transputer_models(),
            .attributes = transputer_attributes(),
            .kept = kept_attributes(),
            .executes = Execution::in_time,
            .passes_channels_on = true,
            .why_not = what_it_cannot_address,
            .faults = {{.name = "halts",
                        .about = "the processor stops executing, and its links stop sending",
                        .attributes = {fault_begins()},
                        .silences_links = true}},
            .make = make_transputer,
            .drawing = {.frame = "#3b5b7a", .heading = "#d5e3f0", .legend = "transputer with its processes"}};
}

} // namespace placedpar
