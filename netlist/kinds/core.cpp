#include "runtime/hardware/core.hpp"
#include "netlist/kinds/computer.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "text/reporter.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr int most_cores = 1024; // our choice: the largest number of threads of a native run
constexpr std::string_view kind_of_cores = "core";

class CoreNode final : public MachineNode {
public:
    CoreNode(MachineParts& parts, std::size_t index)
        : MachineNode(parts, index), core_(simulation().add<hardware::ComputerCore>(node().name, costs())) {}

    Executive* executive() override { return &core_; }
    void report(MachineUse& use) const override {
        use.processors.push_back({node().name, node().type, core_.time_busy(), Time{0}});
    }
    hardware::ComputerCore& core() const { return core_; }

private:
    hardware::CoreCosts costs() const {
        const auto cycles = [this](const char* attribute) { return Cycles{node().integer(attribute)}; };
        return {.clock_hz = node().integer("clock"),
                .communication = cycles("channelcall"),
                .crossing = cycles("crossing"),
                .switching = cycles("switching"),
                .patience = cycles("patience"),
                .waking = cycles("waking"),
                .oversleeping = cycles("oversleeping")};
    }

    hardware::ComputerCore& core_;
};

class SharedMemoryNode final : public MachineNode {
public:
    using MachineNode::MachineNode;

    CarrierPair carriers(std::size_t connection) override {
        const LinkConnection& way = network().connections[connection];
        return {&lane_to(way.b.node), &lane_to(way.a.node)};
    }

private:
    hardware::CoreLane& lane_to(std::size_t core) const {
        return simulation().add<hardware::CoreLane>(dynamic_cast<const CoreNode&>(*parts().nodes[core]).core(),
                                                    node().integer("byterate"));
    }
};

/// Returns whether a device can be put into a slot of the shared memory: a core can, if the slot is empty. Refuses all
/// other devices.
bool takes_core(const Attached& attached, const BusAttachment& core) {
    const auto refuse = [&](const std::string& message, const char* hint) {
        attached.reporter.error(core.connected, message, hint);
        return false;
    };
    const Network& network = attached.network;
    if (network.nodes[core.node].kind->name != kind_of_cores)
        return refuse(fmt::format("\"{}\" is not a core", network.nodes[core.node].name),
                      "cores communicate through a shared memory, other devices over links and buses");
    for (const BusAttachment& other : network.attachments)
        if (other.bus == core.bus && other.slot == core.slot)
            return refuse(fmt::format("two cores are in slot {} of \"{}\"", core.slot, network.nodes[core.bus].name),
                          "each core has a slot of its own");
    return true;
}

std::vector<BusWay> ways_between_cores(const Attached& attached, std::size_t memory) {
    std::vector<BusWay> ways;
    const auto& attachments = attached.network.attachments;
    for (std::size_t a = 0; a < attachments.size(); ++a)
        for (std::size_t b = a + 1; b < attachments.size(); ++b)
            if (attachments[a].bus == memory && attachments[b].bus == memory)
                ways.push_back({a, b, nowhere});
    return ways;
}

AttributeDescription cost(const char* name, std::int64_t by_default, const char* about) {
    return {
        .value = description::integer(
            name, {.unit = "cycles", .by_default = static_cast<double>(by_default), .least = 0, .most = 1e9}, about),
        .json_name = fmt::format("{}_cycles", name)};
}

std::vector<AttributeDescription> core_attributes() {
    std::vector<AttributeDescription> attributes{
        {.value = description::integer(
             "clock", {.unit = "Hz", .by_default = hardware::CoreCosts::usual_clock, .least = 1, .most = 1e12},
             "clock frequency; costs are in cycles of this clock; by default a cycle is 1 ns"),
         .decimal_suffixes = true,
         .json_name = "clock_hz"}};
    attributes.push_back(cost("channelcall", 0, "cost of an input or output between processes of one core"));
    attributes.push_back(cost("crossing", 0, "cost of an input or output between processes of two cores"));
    attributes.push_back(cost("switching", 0, "cost of a switch to the next process"));
    attributes.push_back(cost("patience", 20'000, "time without work after which the thread sleeps"));
    attributes.push_back(cost("waking", 0, "time to wake a sleeping thread"));
    attributes.push_back(cost(
        "oversleeping", 0, "extra length of each pause in which an idle MPI rank sleeps; 0: messages wake the thread"));
    return attributes;
}

} // namespace

DeviceKind core() {
    return {.name = std::string(kind_of_cores),
            .noun = "a core",
            .about = "A core that runs one thread of a native run: its processes run in turn, whatever their priority, "
                     "and the thread sleeps while it has no work.",
            .models = {{.name = "core"}},
            .attributes = core_attributes(),
            .executes = Execution::in_time,
            .bus = BusRole::workstation,
            .make = make_device<CoreNode>,
            .drawing = {.frame = "#2f6b4f", .heading = "#d3ecdf", .legend = "core with its processes"}};
}

DeviceKind shared_memory() {
    return {.name = "shared memory",
            .noun = "a shared memory",
            .about = "The memory through which the cores in slot[1] to slot[1024] communicate.",
            .models = {{.name = "shared_memory"}},
            .attributes = {{.value = description::integer(
                                "byterate", {.unit = "bytes/s", .by_default = 1'000'000'000, .least = 1, .most = 1e15},
                                "bytes of messages that a core copies in a second"),
                            .decimal_suffixes = true,
                            .json_name = "bytes_per_second"}},
            .medium = Medium{.slots = most_cores, .shares_ways = true, .takes = takes_core, .ways = ways_between_cores},
            .make = make_device<SharedMemoryNode>,
            .drawing = {.frame = "#7a6a3b", .heading = "#f3e9c9", .legend = "shared memory"}};
}

} // namespace placedpar
