#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/repeated_run.hpp"
#include "netlist/run_report.hpp"
#include "netlist/software.hpp"
#include "runtime/hardware/bus_memory.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/hardware/switched_lane.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace placedpar {

/// A network turned into a simulation: its processors, links and processes, wired as the netlist says.
/// Runs once.
class Machine {
public:
    /// Throws RefusedInput, which names all of them, if processes' kinds are not in the catalogue or stand for programs
    /// that PlacedPar does not have, or if channels lead to an edge, where no process is.
    Machine(const Network&, const Catalogue&, std::uint64_t seed);

    /// Throws UserError when a process refuses to work with what it was given, with its place, and when the run would
    /// pass the end of virtual time.
    RunReport run(Time limit = Time::max());
    Simulation& simulation() { return simulation_; }
    /// Notes what the processes do, so that the run can be repeated with other seeds. REQUIRES: before run(); the
    /// record outlives it, is empty, and is not moved meanwhile.
    void record(RecordedRun&);
    /// REQUIRES: before run(). See Kernel::shuffle.
    void shuffle(std::uint64_t seed) { simulation_.shuffle(seed); }
    /// REQUIRES: before run(); the sink outlives it.
    void trace_to(TraceSink& sink) { simulation_.trace_to(sink); }

private:
    /// Both directions of a connection.
    struct Carriers {
        Carrier *from_a_to_b = nullptr, *from_b_to_a = nullptr;
    };
    /// One message for all of them.
    struct Broadcast {
        std::vector<std::size_t> channels;
        hardware::AdapterBroadcast* writer = nullptr;
    };
    void make_executives();
    void make_links();
    void make_switched(std::size_t connection);
    hardware::SharedEngine& engine_at(const LinkEnd&, bool outputs);
    void make_buses();
    void make_way(std::size_t connection);
    Carriers make_memory_lanes(const BusWay&);
    Carriers make_adapter(std::size_t connection);
    void make_broadcasts();
    void add_to_broadcast(std::size_t channel);
    hardware::Lane lane(std::size_t connection, bool from_a_to_b) const;
    void make_faults();
    void strike_links_at(const Fault&);
    void hog(const Fault&);
    void leave_bus(const Fault&);
    void strike_link(std::size_t connection, const hardware::LinkFault&);
    void make_routers();
    hardware::RouterLink& make_router_link(std::size_t connection);
    void place_channels();
    void carry(std::size_t channel);
    void start_processes();

    std::vector<ProcessorUse> processor_uses() const;
    Time time_passing_on(std::size_t node) const;
    std::vector<LinkUse> link_uses() const;
    std::vector<BusUse> bus_uses() const;
    std::vector<BroadcastUse> broadcast_uses(const hardware::VmeBus&) const;
    std::vector<ProcessUse> process_uses() const;
    std::vector<FaultUse> fault_uses() const;
    std::vector<SwitchUse> switch_uses() const;
    SwitchUse use_of(std::size_t node, const hardware::Crossbar&) const;
    std::vector<std::string> stopped_on(std::size_t node) const;
    std::vector<std::string> channels_stopped_by(const Fault&) const;
    bool is_stopped_by(const hardware::Route&, const Fault&) const;

    RecordedRun* record_ = nullptr; ///< null: none is wanted
    Network network_;
    Software software_;
    Simulation simulation_;
    std::vector<NodeExecutive> executives_;                                ///< by node
    std::vector<hardware::Link*> links_;                                   ///< by connection; null for ways over a bus
    std::vector<std::vector<const hardware::FaultEffect*>> fault_effects_; ///< by fault, of each link it strikes
    std::vector<hardware::VmeMaster*> hogs_;                               ///< by fault; null where it is of no bus
    std::vector<const hardware::BusSlave::Absence*> absences_;             ///< by fault; null where it is none
    std::vector<hardware::VmeBus*> buses_;                                 ///< by node; null where it is none
    std::vector<hardware::VmeMaster*> masters_;                            ///< by attachment; null where it is none
    std::vector<hardware::DualPortedMemory*> memories_;                    ///< by attachment; null where it has none
    std::vector<hardware::BusSlave*> slaves_;                              ///< by node; null where it answers no master
    std::vector<Carriers> carriers_;                                       ///< by connection
    std::map<std::size_t, hardware::AdapterProgram*> adapters_;            ///< by connection that leads over one
    std::vector<Broadcast> broadcasts_;                                    ///< in the order of their first channels
    /// Of links that switches connect during the run, by node, link and whether it outputs.
    std::map<std::tuple<std::size_t, int, bool>, hardware::SharedEngine> engines_;
    std::vector<hardware::Router*> routers_;          ///< by node
    std::vector<hardware::RouterLink*> router_links_; ///< by connection; null where no channel travels in packets
    std::vector<const hardware::Route*> routes_;      ///< by channel; null where it does not travel in packets
};

} // namespace placedpar
