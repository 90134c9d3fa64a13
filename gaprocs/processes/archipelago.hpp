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

/// An island of a netlist. The others are known by their numbers.
struct PlacedIsland {
    std::size_t process;                                     ///< its place in Network::processes
    std::vector<std::size_t> neighbours;                     ///< in the order in which a sequential schedule takes them
    std::map<std::size_t, std::string> ports_to, ports_from; ///< by the number of the other
    /// Connections that no topology has, by port: to the island itself, to one and the same twice, to no island.
    std::map<std::string, std::string> refused;
    std::size_t part; ///< its place in Archipelago::parts()
};

/// What the topology that an island names would connect, were it of all islands.
struct NamedTopology {
    Neighbours neighbours;
    std::string does_not_fit; ///< why; "" where it does
};

/// The islands of a netlist, the processes of the kind ga.island: numbered from 0 in the order in which they are
/// declared, and neighbours as they are connected. Those of an island whose parameter `topology` is not "given" stand
/// in that topology's order, if it has the same. To make one takes a time that grows with the netlist: one serves all
/// islands.
class Archipelago {
public:
    explicit Archipelago(const Network&);

    const std::vector<PlacedIsland>& islands() const { return islands_; }
    /// The number of the island that is this process. REQUIRES: it is one.
    std::size_t number_of(std::size_t process) const;
    const Neighbours& neighbours() const { return neighbours_; }
    const std::vector<std::vector<std::size_t>>& parts() const { return parts_; }
    /// The islands with which this one exchanges, by way of others too; itself included.
    const std::vector<std::size_t>& part_of(std::size_t island) const { return parts_[islands_[island].part]; }
    /// The most that an island of its part needs for its first generation.
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

/// The one of a network that runs, for all of its islands. REQUIRES: while it is held, the network lives and
/// stays as it is.
std::shared_ptr<const Archipelago> archipelago_of(const Network&);

/// The parameters `schedule` and `exchange_every` of an island: the second says how often where the first does not.
Schedule schedule_of(const ProcessInstance&);
/// Whether the text of a schedule says how often: "sequential(5)".
bool says_how_often(const std::string& schedule);

} // namespace placedpar
