#pragma once

#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <map>
#include <optional>
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
};

/// The islands of a netlist, the processes of the kind ga.island: numbered from 0 in the order in which they are
/// declared, and neighbours as they are connected. Those of an island whose parameter `topology` is not "given" stand
/// in that topology's order, if it has the same.
class Archipelago {
public:
    explicit Archipelago(const Network&);

    const std::vector<PlacedIsland>& islands() const { return islands_; }
    /// The number of the island that is this process. REQUIRES: it is one.
    std::size_t number_of(std::size_t process) const;
    Neighbours neighbours() const;
    /// The islands with which this one exchanges, by way of others too; itself included.
    std::vector<std::size_t> part_of(std::size_t island) const;

private:
    void add_neighbours(const Network&, std::size_t island);
    void add_neighbour(const Network&, PlacedIsland&, const PortBinding&);

    std::vector<PlacedIsland> islands_;
    std::map<std::size_t, std::size_t> numbers_; ///< by process
};

/// The parameters `schedule` and `exchange_every` of an island: the second says how often where the first does not.
Schedule schedule_of(const ProcessInstance&);
/// Whether the text of a schedule says how often: "sequential(5)".
bool says_how_often(const std::string& schedule);

} // namespace placedpar
