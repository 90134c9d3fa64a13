#pragma once

#include "netlist/network/network.hpp"
#include "netlist/read.hpp"
#include "netlist/run_report.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A change of a netlist, as `placedpar run --set` makes it, to find out how much faster the run would be.
struct Change {
    /// Says what the change affects: all parts of a kind, the processors of an array, a single part or process, a
    /// constant, or the number of processes or processors.
    enum class Of { all, array, alone, constant, number } of;
    std::string what;   ///< "processors of master[]"
    std::string change; ///< "twice as fast"
    Overrides set;
};

/// A function that returns what the netlist declares with these settings, even if they make the netlist invalid.
using DeclaredWith = std::function<Declared(const Overrides&)>;

/// Returns the changes worth trying. Processors, links and buses become 10 % faster, twice as fast, and as fast as a
/// netlist allows (1 GHz, 1 Gbit/s, 1 ns per word). Each of these changes applies to all parts of a kind, to the
/// processors of an array's processes, or to one of the ten busiest parts of a kind. Memory becomes as fast as on-chip
/// memory. Constants in cycles or bytes are reduced by 10 %, halved, and set to 0. The cycles of single processes are
/// reduced in the same way, for the ten busiest processes that share a processor with others. Constants that determine
/// the number of processes or processors are raised by one. In a network of more than 256 nodes, the changes are only
/// "twice as fast" and "halved", and only the three busiest parts of each kind are changed alone.
std::vector<Change> changes_of(const Network&, const RunReport&, const DeclaredWith&);

} // namespace placedpar
