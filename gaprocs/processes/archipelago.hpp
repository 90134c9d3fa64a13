#pragma once

#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// An island of a netlist: a process that searches and exchanges individuals with its neighbours.
struct PlacedIsland {
    std::size_t process; ///< index in Network::processes
    /// Numbers of the neighbours, in the order in which a sequential schedule sends to them.
    std::vector<std::size_t> neighbours;
    std::map<std::size_t, std::string> ports_to,
        ports_from; ///< by island number: name of the port to, or from, this island
    /// Messages about wrong connections, by port: a connection to the island itself, a second connection to the same
    /// island, or a connection to a process that is not an island.
    std::map<std::string, std::string> refused;
    std::size_t part; ///< index in Archipelago::parts()
};

/// A topology that the netlist names, applied to all islands.
struct NamedTopology {
    Neighbours neighbours;
    std::string does_not_fit; ///< why the topology cannot have this number of islands; "" if it can
};

/// All islands of a netlist, that is, the processes of the kind ga.island, and their neighbours. Islands are numbered
/// from 0 in the order of their declarations. The neighbours of an island are in the order of its connections. But if
/// the parameter `topology` names a topology that gives the island the same neighbours, they are in the order of this
/// topology. The constructor reads the whole netlist, so all islands share one archipelago to save time.
class Archipelago {
public:
    explicit Archipelago(const Network&);

    const std::vector<PlacedIsland>& islands() const { return islands_; }
    /// Returns the number of an island. REQUIRES: `process` is an island's index in Network::processes.
    std::size_t number_of(std::size_t process) const;
    const Neighbours& neighbours() const { return neighbours_; }
    const std::vector<std::vector<std::size_t>>& parts() const { return parts_; }
    /// Returns the part of the island: the island itself, and all islands with which it exchanges, directly or through
    /// other islands.
    const std::vector<std::size_t>& part_of(std::size_t island) const { return parts_[islands_[island].part]; }
    /// Returns the largest number of samples that an island of the same part needs before its first generation. Islands
    /// that exchange in step wait for this number.
    std::size_t samples_needed_around(std::size_t island) const { return samples_needed_[islands_[island].part]; }
    /// REQUIRES: `text` is the parameter `topology` of an island.
    const NamedTopology& topology(const std::string& text) const { return topologies_.at(text); }

private:
    void add_neighbours(const Network&, PlacedIsland&);
    void add_neighbour(const Network&, PlacedIsland&, const PortBinding&);
    void order_neighbours(const std::string& topology, std::size_t island);
    void add_parts(const Network&);

    std::vector<PlacedIsland> islands_;
    Neighbours neighbours_;
    std::map<std::string, NamedTopology> topologies_;
    std::vector<std::vector<std::size_t>> parts_;
    std::vector<std::size_t> samples_needed_;    ///< samples_needed_around() of each part
    std::map<std::size_t, std::size_t> numbers_; ///< number of each island, by process
};

/// Returns the archipelago that all islands of a network share. REQUIRES: the network outlives the archipelago and does
/// not change.
std::shared_ptr<const Archipelago> archipelago_of(const Network&);

/// Returns the schedule of an island. The number of generations between exchanges is in the parameter `schedule`, as in
/// "sequential(5)", or otherwise in `exchange_every`.
Schedule schedule_of(const ProcessInstance&);
/// Returns whether the text of a schedule contains the number of generations between exchanges, as "sequential(5)"
/// does.
bool says_how_often(const std::string& schedule);

} // namespace placedpar
