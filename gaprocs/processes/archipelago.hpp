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

/// An island of a netlist. Islands refer to each other by number.
struct PlacedIsland {
    std::size_t process;                 ///< index in Network::processes
    std::vector<std::size_t> neighbours; ///< numbers of the neighbours, in the order of a sequential schedule
    std::map<std::size_t, std::string> ports_to, ports_from; ///< port, by number of the neighbour
    /// Errors in the connections, by port: a connection to the island itself, a second one to the same island, or one
    /// to a process that is not an island.
    std::map<std::string, std::string> refused;
    std::size_t part; ///< index in Archipelago::parts()
};

/// The connections that the topology named by an island would make between all islands.
struct NamedTopology {
    Neighbours neighbours;
    std::string does_not_fit; ///< why the topology does not fit the number of islands; "" if it fits
};

/// The islands of a netlist: its processes of the kind ga.island, numbered from 0 in the order of their declarations,
/// with their neighbours in the order of the connections. If an island's parameter `topology` is not "given", and that
/// topology has the same neighbours, they are in the topology's order. Construction takes time in proportion to the
/// netlist, so that all islands share one archipelago.
class Archipelago {
public:
    explicit Archipelago(const Network&);

    const std::vector<PlacedIsland>& islands() const { return islands_; }
    /// Returns the number of the island. REQUIRES: the process is an island.
    std::size_t number_of(std::size_t process) const;
    const Neighbours& neighbours() const { return neighbours_; }
    const std::vector<std::vector<std::size_t>>& parts() const { return parts_; }
    /// Returns the islands that exchange with this one, directly or through other islands, including itself.
    const std::vector<std::size_t>& part_of(std::size_t island) const { return parts_[islands_[island].part]; }
    /// Returns the largest number of samples that any island of this island's part needs for its first generation.
    std::size_t samples_needed_around(std::size_t island) const { return samples_needed_[islands_[island].part]; }
    /// REQUIRES: the text is an island's parameter `topology`, and not "given".
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
    std::vector<std::size_t> samples_needed_;    ///< by part
    std::map<std::size_t, std::size_t> numbers_; ///< by process
};

/// Returns the archipelago that all islands of a running network share. REQUIRES: the network outlives it and does not
/// change.
std::shared_ptr<const Archipelago> archipelago_of(const Network&);

/// Returns the schedule that the island's parameters give: `exchange_every` gives the interval if `schedule` does not.
Schedule schedule_of(const ProcessInstance&);
/// Returns whether the text of a schedule contains the interval, as "sequential(5)" does.
bool says_how_often(const std::string& schedule);

} // namespace placedpar
