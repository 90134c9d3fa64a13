#include "netlist/kinds/vme.hpp"

#include "text/reporter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

class VmeWays {
public:
    VmeWays(const Attached& attached, std::size_t bus) : attached_(attached), bus_(bus) {}

    std::vector<BusWay> find() {
        for (std::size_t slave = 0; slave < attachments().size(); ++slave)
            if (is_here(slave) && kind_of(slave).bus == BusRole::adapter)
                lead_over_adapter(slave);
        for (std::size_t master = 0; master < attachments().size(); ++master)
            for (std::size_t slave = 0; slave < attachments().size(); ++slave)
                if (shares_memory_with(slave, master))
                    ways_.push_back({master, slave, nowhere});
        return std::move(ways_);
    }

private:
    const std::vector<BusAttachment>& attachments() const { return attached_.network.attachments; }
    const Node& node(std::size_t attachment) const { return attached_.node(attachment); }
    const DeviceKind& kind_of(std::size_t attachment) const { return *node(attachment).kind; }
    bool is_here(std::size_t attachment) const { return attachments()[attachment].bus == bus_; }

    /// Returns true if a way leads from `master` to the memory of `slave`. Two bus masters can access each other's
    /// memory. A single way joins them; it leads from the master that was attached first.
    bool shares_memory_with(std::size_t slave, std::size_t master) const {
        return slave != master && is_here(slave) && is_here(master) && kind_of(slave).bus == BusRole::bus_master &&
               kind_of(master).is_master() && (kind_of(master).bus == BusRole::workstation || master < slave);
    }

    void lead_over_adapter(std::size_t slave) {
        auto wire = attached_.connection_at.find({attachments()[slave].node, 0});
        if (wire == attached_.connection_at.end())
            return; // an adapter without a wire at its link is not used
        if (const LinkConnection& led = attached_.network.connections[wire->second]; led.at_run_time)
            return attached_.reporter.error(
                led.connected,
                fmt::format("the link of the adapter \"{}\" leads to a switch that a program sets during the run",
                            node(slave).name),
                "an adapter leads to one processor for the whole run");
        if (std::size_t master = master_of(slave); master != nowhere)
            ways_.push_back({master, slave, wire->second});
    }

    /// Returns the master whose program uses the link adapter. If there is no master, or if several are possible,
    /// reports an error and returns nowhere.
    std::size_t master_of(std::size_t slave) {
        const Node& adapter = node(slave);
        const auto& named = std::get<std::string>(adapter.attributes.at("master"));
        std::vector<std::size_t> masters, workstations;
        for (std::size_t i = 0; i < attachments().size(); ++i)
            if (is_here(i) && kind_of(i).is_master() && (named.empty() || node(i).name == named)) {
                masters.push_back(i);
                if (kind_of(i).bus == BusRole::workstation)
                    workstations.push_back(i);
            }
        const auto& candidates = workstations.empty() ? masters : workstations;
        if (candidates.size() == 1)
            return candidates.front();
        refuse_master(adapter, attached_.network.nodes[bus_], named, candidates);
        return nowhere;
    }

    void refuse_master(const Node& adapter, const Node& bus, const std::string& named,
                       const std::vector<std::size_t>& candidates) {
        if (!named.empty())
            attached_.reporter.error(
                adapter.declared,
                fmt::format("the master of the link adapter \"{}\" is \"{}\", which is not a master on its "
                            "bus \"{}\"",
                            adapter.name, named, bus.name),
                "the masters of a bus are the workstations and bus masters that are connected to it");
        else if (candidates.empty())
            attached_.reporter.error(
                adapter.declared,
                fmt::format("no master on the bus \"{}\" can use the link adapter \"{}\"", bus.name, adapter.name),
                "connect a workstation or a bus master to the bus: connect sun.bus[0] to " + bus.name + ".slot[1];");
        else
            attached_.reporter.error(
                adapter.declared,
                fmt::format("the master that uses the link adapter \"{}\" is ambiguous: \"{}\" or \"{}\"", adapter.name,
                            node(candidates[0]).name, node(candidates[1]).name),
                fmt::format("{} (master = \"{}\") ...;", adapter.type, node(candidates[0]).name));
    }

    const Attached& attached_;
    std::size_t bus_;
    std::vector<BusWay> ways_;
};

} // namespace

/// Returns whether a device can be attached to the bus. Reports a request level that the arbiter does not have. Also
/// reports a second master in a slot, because the grant of the bus is offered to each slot only once.
bool can_be_attached(const Attached& attached, const BusAttachment& attachment) {
    const Network& network = attached.network;
    if (!network.nodes[attachment.node].kind->is_master())
        return true;
    const Node& bus = network.nodes[attachment.bus];
    const std::string& name = network.nodes[attachment.node].name;
    for (const BusAttachment& other : network.attachments)
        if (other.bus == attachment.bus && other.slot == attachment.slot &&
            network.nodes[other.node].kind->is_master()) {
            attached.reporter.error(attachment.connected,
                                    fmt::format("\"{}\" and \"{}\" are both masters in slot {} of \"{}\"",
                                                network.nodes[other.node].name, name, other.slot, bus.name),
                                    "a slot holds one master, and any number of link adapters",
                                    {{"first connected here", other.connected}});
            return false;
        }
    if (!has_single_level(bus) || attachment.level == 3)
        return true;
    attached.reporter.error(
        attachment.connected,
        fmt::format("\"{}\" requests at level {}, but the arbiter of \"{}\" is SGL", name, attachment.level, bus.name),
        "SGL grants level 3 only; \"PRI\" and \"RRS\" grant all four levels");
    return false;
}

std::vector<BusWay> ways_over_bus(const Attached& attached, std::size_t bus) { return VmeWays(attached, bus).find(); }

bool has_single_level(const Node& bus) { return bus.attributes.at("arbiter") == Value("SGL"); }

int free_slot(const Network& network, std::size_t bus, std::size_t taken) {
    int slot = vme_slots;
    for (; slot >= 1; --slot) {
        bool used = std::ranges::any_of(
            network.attachments, [&](const BusAttachment& each) { return each.bus == bus && each.slot == slot; });
        if (!used && taken-- == 0)
            break;
    }
    return slot;
}

} // namespace placedpar
