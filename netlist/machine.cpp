#include "netlist/machine.hpp"

#include "netlist/network/names.hpp"
#include "netlist/runnable.hpp"
#include "runtime/timer.hpp"
#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <system_error>

namespace placedpar {

namespace {

/// REQUIRES: the network can be run.
const ProcessKind& kind_of(const ProcessInstance& process, const Catalogue& catalogue) {
    return *catalogue.find(process.kind);
}

/// Which process it was, and when if not at the start.
std::string failing(const ProcessInstance& process) {
    std::string when = now() == Time{0} ? "" : " at " + to_string(now());
    return fmt::format("process {} ({}){}", process.name, process.kind, when);
}

/// The same, and where it was declared.
std::string failure_of(const ProcessInstance& process, const char* why) {
    std::string place = process.declared.text();
    return fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ", failing(process), why);
}

/// Runs a process's program. What it refuses to work with, and what is wrong with the program itself, is reported with
/// the process, after a file's own places; what the system refuses is not the process's fault.
void run_body(const ProcessInstance& process, const std::function<void(ProcessEnvironment&)>& body,
              ProcessEnvironment& environment) {
    try {
        body(environment);
    } catch (const RefusedInput& refused) {
        throw RefusedInput(refused.what() + render(SecondPlace{"read by " + failing(process), process.declared}));
    } catch (const UserError& refused) {
        throw UserError(failure_of(process, refused.what()));
    } catch (const hardware::BusError& error) { // of a machine with a fault, which the program does not provide for
        throw UserError(failure_of(process, error.what()));
    } catch (const std::system_error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& defect) {
        throw std::logic_error(failure_of(process, defect.what()));
    }
}

/// Hundredths of a bit time that a bit needs to cross the switches on its way.
std::int64_t crossing_delay(const LinkConnection& connection, const std::vector<Node>& nodes) {
    std::int64_t hundredths = 0;
    for (const SwitchCrossing& crossing : connection.crossings)
        hundredths += nodes[crossing.node].kind->crossing_delay;
    return hundredths;
}

Time wire_delay(const LinkConnection& connection, const std::vector<Node>& nodes) {
    constexpr auto metre = static_cast<double>(hardware::LinkTiming::metre_of_wire.count());
    return Time{static_cast<std::int64_t>(connection.metres * metre)} +
           duration_of(crossing_delay(connection, nodes), 100 * connection.bits_per_second);
}

/// A link overlaps its acknowledges where both of its ends can.
hardware::LinkTiming timing_of(const LinkConnection& connection, const std::vector<Node>& nodes) {
    hardware::LinkTiming timing{.bits_per_second = connection.bits_per_second,
                                .wire_delay = wire_delay(connection, nodes)};
    for (const LinkEnd& end : {connection.a, connection.b})
        timing.overlapped_acknowledge = timing.overlapped_acknowledge && nodes[end.node].overlapped_acknowledge;
    return timing;
}

hardware::Link& add_link(Simulation& simulation, const LinkConnection& connection, const std::vector<Node>& nodes) {
    return simulation.add<hardware::Link>(timing_of(connection, nodes), link_name(nodes, connection.a),
                                          link_name(nodes, connection.b));
}

const PortDescription& port_of(const ProcessInstance& process, std::string_view name, const Catalogue& catalogue) {
    return *kind_of(process, catalogue).port(base_name(name));
}

bool travels_in_packets(const NetworkChannel& channel) {
    return channel.placement.kind == ChannelPlacement::Kind::link && channel.placement.in_packets;
}

} // namespace

Machine::Machine(const Network& network, const Catalogue& catalogue, std::uint64_t seed)
    : network_(network), seed_(seed) {
    require_runnable(network, catalogue);
    make_executives();
    make_links();
    make_buses();
    make_faults();
    make_routers();
    make_channels(catalogue);
    make_processes(catalogue);
    expect_partners();
}

void Machine::make_executives() {
    for (std::size_t i = 0; i < network_.nodes.size(); ++i) {
        const DeviceKind& kind = *network_.nodes[i].kind;
        bool differs = kind.make_executive_on_bus && is_on_bus(network_, i);
        const auto& make = differs ? kind.make_executive_on_bus : kind.make_executive;
        executives_.push_back(make ? make(simulation_, network_.nodes[i]) : NodeExecutive{});
    }
}

void Machine::make_links() {
    carriers_.resize(network_.connections.size());
    for (const LinkConnection& connection : network_.connections) {
        if (connection.over_bus) {
            links_.push_back(nullptr);
            continue;
        }
        links_.push_back(&add_link(simulation_, connection, network_.nodes));
        carriers_[links_.size() - 1] = {&links_.back()->from_a_to_b(), &links_.back()->from_b_to_a()};
        if (connection.at_run_time)
            make_switched(links_.size() - 1);
        for (const LinkEnd& end : {connection.a, connection.b})
            if (const auto& has_link = executives_[end.node].has_link)
                has_link(*links_.back());
    }
}

/// The switches that a program sets decide what gets over; the engines at its ends may be those of other links, too.
void Machine::make_switched(std::size_t index) {
    const LinkConnection& connection = network_.connections[index];
    hardware::Link& link = *links_[index];
    for (const SwitchCrossing& crossing : connection.crossings)
        if (is_set_at_run_time(network_, crossing.node))
            executives_[crossing.node].crossbar->lead_on(link, crossing.from_link, crossing.to_link);
    auto lane = [&](hardware::LinkDirection& direction, const LinkEnd& from, const LinkEnd& to) {
        return &simulation_.add<hardware::SwitchedLane>(direction, engine_at(from, true), engine_at(to, false));
    };
    carriers_[index] = {lane(link.from_a_to_b(), connection.a, connection.b),
                        lane(link.from_b_to_a(), connection.b, connection.a)};
}

hardware::SharedEngine& Machine::engine_at(const LinkEnd& end, bool outputs) {
    return engines_.try_emplace({end.node, end.link, outputs}, hardware::SharedEngine{link_name(network_.nodes, end)})
        .first->second;
}

void Machine::make_routers() {
    for (const NodeExecutive& each : executives_)
        routers_.push_back(&simulation_.add<hardware::Router>(each.executive));
    router_links_.resize(links_.size());
    for (const NetworkChannel& channel : network_.channels)
        if (travels_in_packets(channel))
            for (const RouteHop& hop : channel.placement.route)
                if (auto& link = router_links_[hop.connection]; !link)
                    link = &make_router_link(hop.connection);
}

hardware::RouterLink& Machine::make_router_link(std::size_t index) {
    const LinkConnection& connection = network_.connections[index];
    return simulation_.add<hardware::RouterLink>(lane(index, true), lane(index, false), *routers_[connection.a.node],
                                                 *routers_[connection.b.node]);
}

hardware::Lane Machine::lane(std::size_t index, bool from_a_to_b) const {
    const LinkConnection& connection = network_.connections[index];
    std::string a = link_name(network_.nodes, connection.a), b = link_name(network_.nodes, connection.b);
    const Carriers& both = carriers_[index];
    return from_a_to_b ? hardware::Lane{*both.from_a_to_b, a + " -> " + b}
                       : hardware::Lane{*both.from_b_to_a, b + " -> " + a};
}

void Machine::make_channels(const Catalogue& catalogue) {
    for (const NetworkChannel& channel : network_.channels) {
        const ProcessInstance& sender = network_.processes[channel.from.process];
        channels_.push_back(port_of(sender, channel.from.port, catalogue).make_channel(channel.name));
    }
    routes_.resize(channels_.size());
    for (std::size_t i = 0; i < channels_.size(); ++i)
        if (const ChannelPlacement& at = network_.channels[i].placement;
            at.kind == ChannelPlacement::Kind::link && at.broadcast_on == nowhere)
            carry(i);
    for (const Broadcast& each : broadcasts_)
        for (std::size_t i = 0; i < each.channels.size(); ++i)
            each.writer->carry(*channels_[each.channels[i]], i);
}

void Machine::carry(std::size_t index) {
    AnyChannel& channel = *channels_[index];
    std::vector<hardware::Hop> hops;
    for (auto [connection, forth] : network_.channels[index].placement.route) {
        if (!router_links_[connection]) // then there is no other hop
            return channel.put_on(forth ? *carriers_[connection].from_a_to_b : *carriers_[connection].from_b_to_a);
        hops.push_back({*router_links_[connection], forth});
    }
    auto& route = simulation_.add<hardware::Route>(hops);
    channel.put_on(route);
    routes_[index] = &route;
}

void Machine::make_processes(const Catalogue& catalogue) {
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        processes_.push_back(&make_process(i, kind_of(network_.processes[i], catalogue)));
}

void Machine::expect_partners() {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        channels_[i]->expect_outputter(*processes_[network_.channels[i].from.process]);
        channels_[i]->expect_inputter(*processes_[network_.channels[i].to.process]);
    }
}

Process& Machine::make_process(std::size_t index, const ProcessKind& kind) {
    const ProcessInstance& process = network_.processes[index];
    std::vector<ProcessEnvironment::Port> ports;
    for (const PortBinding& binding : process.ports)
        ports.push_back({binding.port, channels_[binding.channel].get()});
    ProcessEnvironment& environment =
        environments_.emplace_back(network_, index, std::move(ports), seed_, measurements_);
    Process& made = simulation_.process(
        process.name, [&process, &environment, body = kind.body] { run_body(process, body, environment); },
        executives_[process.node].executive, process.high_priority ? Priority::high : Priority::low);
    if (network_.nodes[process.node].kind->is_set_by_link())
        made.serve_machine(); // it is a part of the switch, and never ends
    return made;
}

} // namespace placedpar
