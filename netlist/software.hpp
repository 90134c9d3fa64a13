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

/// Holds the processes of a network and their channels, independently of the machine on which the processes run.
class Software {
public:
    /// Makes all channels, as soft channels. Throws RefusedInput as require_runnable() does. REQUIRES: network and
    /// catalogue outlive this object.
    Software(const Network&, const Catalogue&, std::uint64_t seed);
    Software(const Software&) = delete;
    Software& operator=(const Software&) = delete;

    /// Returns the channel with this index in Network::channels.
    AnyChannel& channel(std::size_t index) const { return *channels_[index]; }

    /// Makes all processes. `executives` holds an executive for each node, or null if processes there take no time.
    /// REQUIRES: called once, and this object outlives the simulation's run.
    void start(Simulation&, const std::vector<Executive*>& executives);
    /// Makes the processes of some nodes. `executive` executes them; if it is null, they take no time. REQUIRES: as for
    /// start().
    void start_natively(Simulation&, const std::vector<bool>& nodes, Executive* executive = nullptr);
    /// Declares which processes use the ends of all channels. `all` holds the processes by their index in
    /// Network::processes, including processes that another Software made; null for processes that are in another
    /// program.
    void expect_partners(const std::vector<Process*>& all);
    /// Returns the processes by their index in Network::processes; null for processes that this object has not made.
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
