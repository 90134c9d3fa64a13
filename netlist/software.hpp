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

/// The processes of a network and their channels, whatever they run on.
class Software {
public:
    /// Makes the channels: soft ones. Throws RefusedInput as require_runnable. REQUIRES: network and catalogue outlive
    /// it.
    Software(const Network&, const Catalogue&, std::uint64_t seed);
    Software(const Software&) = delete;
    Software& operator=(const Software&) = delete;

    /// By their place in Network::channels.
    AnyChannel& channel(std::size_t index) const { return *channels_[index]; }

    /// Makes all processes, `executives` by node: null where they take no time. REQUIRES: called once, and it outlives
    /// the simulation's run.
    void start(Simulation&, const std::vector<Executive*>& executives);
    /// By their place in Network::processes.
    const std::vector<Process*>& processes() const { return processes_; }

    const Catalogue& catalogue() const { return catalogue_; }

    /// So far, in their order.
    const std::vector<Measurement>& measurements() const { return measurements_; }

private:
    Process& start(Simulation&, std::size_t process, Executive*);
    void expect_partners();

    const Network& network_;
    const Catalogue& catalogue_;
    std::uint64_t seed_;
    std::vector<std::unique_ptr<AnyChannel>> channels_;
    std::list<ProcessEnvironment> environments_;
    std::vector<Process*> processes_;
    std::vector<Measurement> measurements_;
};

} // namespace placedpar
