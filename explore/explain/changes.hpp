#pragma once

#include "netlist/network/network.hpp"
#include "netlist/read.hpp"
#include "netlist/run_report.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A change of a netlist, as `placedpar run --set` makes it.
struct Change {
    /// Says what the change affects: everything of a sort, what an array runs on, a single part of the machine or a
    /// single process, a constant of a process, or a number of things.
    enum class Of { all, array, alone, constant, number } of;
    std::string what;   ///< "processors of master[]"
    std::string change; ///< "twice as fast"
    Overrides set;
};

/// What the netlist declares with these settings, even where it is refused with them.
using DeclaredWith = std::function<Declared(const Overrides&)>;

/// The changes worth asking about: all processors, those on which the processes of an array run, the links and the
/// buses a tenth faster, twice as fast, and as fast as can be said (1 GHz, 1 Gbit/s, 1 ns a word); the same of the ten
/// processors, the ten links, the ten buses and the ten processes alone that were the busiest in the run; memory as
/// fast as that on the chip; constants in cycles or bytes that processes or processors have, a tenth less, half, none;
/// one more of what a val makes more processes or processors of.
std::vector<Change> changes_of(const Network&, const RunReport&, const DeclaredWith&);

} // namespace placedpar
