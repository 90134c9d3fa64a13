#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "netlist/kinds/own_code.hpp"
#include "netlist/network/network.hpp"
#include "netlist/repeated_run.hpp"
#include "netlist/run_report.hpp"
#include "netlist/software.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace placedpar {

/// Simulates a network, that is, a netlist that has been read and checked: its processors, links and processes. A
/// machine runs once.
class Machine {
public:
    /// Throws RefusedInput if the network cannot be run: see require_runnable() in netlist/runnable.hpp.
    Machine(const Network&, const Catalogue&, std::uint64_t seed);

    /// Throws UserError if a process refuses its parameters or channels, or if the run would pass the end of virtual
    /// time. If a process throws, the text of the error says where the netlist declares this process.
    RunReport run(Time limit = Time::max());
    Simulation& simulation() { return simulation_; }
    /// Records the actions of the processes, so that the run can be repeated with other seeds. REQUIRES: run() has not
    /// been called; the RecordedRun is empty, is not moved, and outlives this object.
    void record(RecordedRun&);
    /// Makes the run execute ready processes in a random order, to find results that depend on this order. The
    /// processes of emulated transputers are included. REQUIRES: run() has not been called. See Kernel::shuffle and
    /// transputer::Core::shuffle.
    void shuffle(std::uint64_t seed);
    /// Sends the events of the run to the sink. REQUIRES: run() has not been called; the sink outlives this object.
    void trace_to(TraceSink& sink) { simulation_.trace_to(sink); }

private:
    struct Connection {
        CarrierPair carriers = {};
        hardware::RouterLink* router_link = nullptr; ///< null if the connection carries no packets; packets are for
                                                     ///< channels that share a link or pass other processors
    };
    /// Holds the effects of one fault in the run.
    struct Effects {
        std::vector<const hardware::FaultEffect*> of_links; ///< one entry for each link that the fault affects
        FaultEffects of_device = {};
    };
    /// Calls a member function of the node's device. An exception in a device that a user's program defines becomes an
    /// error of that program (ask_device in netlist/kinds/own_code.hpp).
    template <class Member, class... Arguments>
    auto ask(std::size_t node, Member member, Arguments&&... arguments) const {
        return ask_device(network_.nodes[node], [&] {
            return std::invoke(member, *parts_.nodes[node], std::forward<Arguments>(arguments)...);
        });
    }
    void make_nodes(bool with_slots);
    void make_links();
    void make_link(const LinkConnection&);
    CarrierPair switched(std::size_t connection);
    void make_ways();
    hardware::RouterLane lane(std::size_t connection, bool from_a_to_b) const;
    void make_faults();
    void silence_links(const Fault&);
    void strike_links_at(const Fault&);
    void strike_link(std::size_t connection, const hardware::LinkFault&);
    void make_router_links();
    hardware::RouterLink& make_router_link(std::size_t connection);
    void place_channels();
    void carry(std::size_t channel);
    void start_processes();

    std::vector<LinkUse> link_uses() const;
    std::vector<ProcessUse> process_uses() const;
    std::vector<FaultUse> fault_uses() const;
    std::vector<std::string> stopped_on(std::size_t node) const;
    std::vector<std::string> channels_stopped_by(const Fault&) const;
    bool is_stopped_by(const hardware::Route&, const Fault&) const;

    RecordedRun* record_ = nullptr; ///< null if the run is not recorded
    Network network_;
    Software software_;
    MachineParts parts_{simulation_, network_, {}, {}};
    Simulation simulation_;
    std::vector<Connection> connections_;
    std::vector<const hardware::Route*> routes_; ///< one for each channel; null if the channel is not sent in packets
    std::vector<Effects> effects_;               ///< one for each fault
};

} // namespace placedpar
