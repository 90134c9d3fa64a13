#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/network/network.hpp"
#include "runtime/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <vector>

namespace placedpar {

/// Makes and holds the processes and channels of a network for one run. The run is on a simulated machine (Machine),
/// from a record (RepeatedRun), or on threads of this computer (native).
class Software {
public:
    /// Makes all channels. Each is a channel in memory until the machine places it on a link. Throws RefusedInput if
    /// the network cannot be run: see require_runnable() in netlist/runnable.hpp. REQUIRES: network and catalogue
    /// outlive this object.
    Software(const Network&, const Catalogue&, std::uint64_t seed);
    Software(const Software&) = delete;
    Software& operator=(const Software&) = delete;

    /// Returns the channel with this index in Network::channels.
    AnyChannel& channel(std::size_t index) const { return *channels_[index]; }

    /// Makes all processes. `executives` has for each node the processor that executes the processes there; null if
    /// these processes take no time. REQUIRES: called once, and this object outlives the simulation's run.
    void start(Simulation&, const std::vector<Executive*>& executives);
    /// Makes only the processes on the nodes whose element of `nodes` is true: the share of one thread or rank of a
    /// native run. `executive` executes the processes; if it is null, they take no time. REQUIRES: called once, and
    /// this object outlives the simulation's run.
    void start_natively(Simulation&, const std::vector<bool>& nodes, Executive* executive = nullptr);
    /// Tells each channel which processes use its ends, so that a deadlock can be explained. `all` holds the processes
    /// by their index in Network::processes, including processes that another Software object made; null for a process
    /// that runs in another program.
    void expect_partners(const std::vector<Process*>& all);
    /// Returns the processes by their index in Network::processes. A process that this object has not made is null.
    const std::vector<Process*>& processes() const { return processes_; }

    const Catalogue& catalogue() const { return catalogue_; }

    /// Returns the measurements so far, in the order in which they were made.
    const std::vector<Measurement>& measurements() const { return measurements_; }

private:
    Process& start(Simulation&, std::size_t process, Executive*);

    const Network& network_;
    const Catalogue& catalogue_;
    std::uint64_t seed_;
    std::vector<std::unique_ptr<AnyChannel>> channels_;
    std::list<ProcessEnvironment> environments_;
    std::vector<Process*> processes_;
    std::vector<Measurement> measurements_;
};

} // namespace placedpar
