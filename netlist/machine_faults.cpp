#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/machine.hpp"

#include <algorithm>

namespace placedpar {

namespace {

const FaultKind& kind_of(const Fault& fault, const Network& network) {
    return *std::ranges::find(network.nodes[fault.node].kind->faults, fault.kind, &FaultKind::name);
}

hardware::LinkFault of_link(const Fault& fault, const LinkConnection& wire) {
    using Kind = hardware::LinkFault::Kind;
    hardware::LinkFault result{.from = begin_of(fault), .until = end_of(fault)};
    result.kind = fault.kind == "silent" ? Kind::silent : fault.kind == "slow" ? Kind::slow : Kind::loses_acknowledge;
    if (result.kind == Kind::slow) {
        result.factor = fault.integer("factor");
        return result;
    }
    bool at_a = wire.a.node == fault.node && wire.a.link == fault.link;
    bool out = fault.text("direction") != "in", in = fault.text("direction") != "out";
    result.wire_from_a = at_a ? out : in;
    result.wire_from_b = at_a ? in : out;
    return result;
}

FaultUse::Hit hit_of(const hardware::FaultEffect::Hit& hit) {
    return {hit.at, hit.channel, hit.acknowledge, hit.byte, hit.message};
}

void add_effect(FaultUse& use, const hardware::FaultEffect& effect) {
    use.bytes_lost += effect.bytes_lost;
    use.acknowledges_lost += effect.acknowledges_lost;
    if (effect.first && (!use.first || effect.first->at < use.first->at))
        use.first = hit_of(*effect.first);
    if (effect.last && (!use.last || effect.last->at >= use.last->at))
        use.last = hit_of(*effect.last);
}

} // namespace

void Machine::strike_link(std::size_t connection, const hardware::LinkFault& fault) {
    effects_.back().of_links.push_back(&parts_.links[connection]->suffer(fault));
}

/// Applies a fault of a link. If switches connect the link to several partners during the run, the fault affects all
/// these connections.
void Machine::strike_links_at(const Fault& fault) {
    LinkEnd end{fault.node, fault.link};
    for (std::size_t i = 0; i < parts_.links.size(); ++i) {
        const LinkConnection& wire = network_.connections[i];
        if (i == fault.connection || (wire.at_run_time && (wire.a == end || wire.b == end)))
            strike_link(i, of_link(fault, wire));
    }
}

/// Silences all links of the failed device, each at the device's end.
void Machine::silence_links(const Fault& fault) {
    for (std::size_t i = 0; i < parts_.links.size(); ++i) {
        bool at_a = network_.connections[i].a.node == fault.node;
        if (!parts_.links[i]) // a way over a bus has no link engine
            continue;
        if (at_a || network_.connections[i].b.node == fault.node)
            strike_link(i, {.from = begin_of(fault), .wire_from_a = at_a, .wire_from_b = !at_a});
    }
}

void Machine::make_faults() {
    for (const Fault& fault : network_.faults) {
        Effects& effects = effects_.emplace_back();
        if (fault.link >= 0) {
            strike_links_at(fault);
            continue;
        }
        effects.of_device = ask(fault.node, &MachineNode::suffer, fault);
        if (kind_of(fault, network_).silences_links)
            silence_links(fault);
    }
}

std::vector<std::string> Machine::stopped_on(std::size_t node) const {
    std::vector<std::string> stopped;
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        if (network_.processes[i].node == node && !software_.processes()[i]->ended() &&
            software_.processes()[i]->executive() && software_.processes()[i]->executive()->halted())
            stopped.push_back(network_.processes[i].name);
    return stopped;
}

/// Returns whether the fault stops packets on the route. A way over a bus to a link adapter contains the wire at the
/// adapter.
bool Machine::is_stopped_by(const hardware::Route& route, const Fault& fault) const {
    if (fault.link < 0) {
        const Executive* executive = parts_.nodes[fault.node]->executive();
        return executive && route.is_stopped_by(*executive);
    }
    for (std::size_t i = 0; i < connections_.size(); ++i) {
        const hardware::RouterLink* link = connections_[i].router_link;
        const auto& over_bus = network_.connections[i].over_bus;
        bool struck = i == fault.connection || (over_bus && over_bus->wire == fault.connection);
        if (struck && link && route.is_stopped_at(*link))
            return true;
    }
    return false;
}

std::vector<std::string> Machine::channels_stopped_by(const Fault& fault) const {
    std::vector<std::string> stopped;
    for (std::size_t i = 0; i < routes_.size(); ++i)
        if (routes_[i] && is_stopped_by(*routes_[i], fault))
            stopped.push_back(software_.channel(i).name());
    return stopped;
}

std::vector<FaultUse> Machine::fault_uses() const {
    std::vector<FaultUse> uses;
    for (std::size_t i = 0; i < network_.faults.size(); ++i) {
        const Fault& fault = network_.faults[i];
        FaultUse& use = uses.emplace_back();
        use.fault = print_fault(fault, network_.nodes);
        for (const hardware::FaultEffect* effect : effects_[i].of_links)
            add_effect(use, *effect);
        if (fault.link < 0)
            use.stopped = stopped_on(fault.node);
        use.stopped_channels = channels_stopped_by(fault);
        if (effects_[i].of_device)
            effects_[i].of_device(use);
    }
    return uses;
}

} // namespace placedpar
