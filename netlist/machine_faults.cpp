#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/machine.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

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
    fault_effects_.back().push_back(&links_[connection]->suffer(fault));
}

/// Of a link that a switch connects during the run, whatever it is connected to.
void Machine::strike_links_at(const Fault& fault) {
    LinkEnd end{fault.node, fault.link};
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const LinkConnection& wire = network_.connections[i];
        if (i == fault.connection || (wire.at_run_time && (wire.a == end || wire.b == end)))
            strike_link(i, of_link(fault, wire));
    }
}

/// A master that none of the netlist's is: it asks when the fault begins, and lets go when it ends.
void Machine::hog(const Fault& fault) {
    std::size_t others = 0;
    for (const hardware::VmeMaster* each : hogs_)
        others += each && &each->bus() == buses_[fault.node];
    hardware::VmePlace place{static_cast<int>(fault.integer("level")), free_slot(network_, fault.node, others)};
    auto& master = simulation_.add<hardware::VmeMaster>(fmt::format("slot {}", place.slot), *buses_[fault.node], place);
    hogs_.back() = &master;
    Time from = begin_of(fault), until = end_of(fault);
    simulation_
        .process(print_fault(fault, network_.nodes),
                 [&master, from, until] {
                     wait_until(from);
                     master.hold_until(until);
                 })
        .serve_machine();
}

/// An adapter without a wire answers nobody anyway.
void Machine::leave_bus(const Fault& fault) {
    if (hardware::BusSlave* slave = slaves_[fault.node])
        absences_.back() = &slave->leave(begin_of(fault), end_of(fault));
}

/// A device that falls silent does so at its end of each of its links.
void Machine::make_faults() {
    for (const Fault& fault : network_.faults) {
        fault_effects_.emplace_back();
        hogs_.push_back(nullptr);
        absences_.push_back(nullptr);
        if (fault.link >= 0) {
            strike_links_at(fault);
            continue;
        }
        if (buses_[fault.node]) {
            hog(fault);
            continue;
        }
        if (leaves_the_bus(fault)) {
            leave_bus(fault);
            continue;
        }
        executives_[fault.node].suffer(fault);
        if (!kind_of(fault, network_).silences_links)
            continue;
        for (std::size_t i = 0; i < links_.size(); ++i) {
            bool at_a = network_.connections[i].a.node == fault.node;
            if (!links_[i]) // a way over a bus, whose master has no engine that could fall silent
                continue;
            if (at_a || network_.connections[i].b.node == fault.node)
                strike_link(i, {.from = begin_of(fault), .wire_from_a = at_a, .wire_from_b = !at_a});
        }
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

/// A way over a bus leads over the wire at its adapter.
bool Machine::is_stopped_by(const hardware::Route& route, const Fault& fault) const {
    if (fault.link < 0) {
        const Executive* executive = executives_[fault.node].executive;
        return executive && route.is_stopped_by(*executive);
    }
    for (std::size_t i = 0; i < router_links_.size(); ++i) {
        const auto& over_bus = network_.connections[i].over_bus;
        bool struck = i == fault.connection || (over_bus && over_bus->wire == fault.connection);
        if (struck && router_links_[i] && route.is_stopped_at(*router_links_[i]))
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
        for (const hardware::FaultEffect* effect : fault_effects_[i])
            add_effect(use, *effect);
        if (const hardware::VmeMaster* master = hogs_[i]; master && master->grants() > 0)
            use.held_since = begin_of(fault) + master->time_waited();
        if (absences_[i])
            use.bus_errors = absences_[i]->unanswered;
        if (fault.link < 0)
            use.stopped = stopped_on(fault.node);
        use.stopped_channels = channels_stopped_by(fault);
    }
    return uses;
}

} // namespace placedpar
