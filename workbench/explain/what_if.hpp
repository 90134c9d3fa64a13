#pragma once

#include "netlist/network/network.hpp"
#include "netlist/read.hpp"
#include "workbench/netlist_run.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// A change of a netlist, as `placedpar run --set` makes it.
struct Change {
    std::string what; ///< "clock of the processors of master[], twice as fast"
    Overrides set;
};

/// What a change makes of the run.
struct Answer {
    Change change;
    Ending ending = Ending::completed;
    Time time{};
    std::string refused = ""; ///< why there is no such machine: the first line; "" if there is
};

/// Reads the netlist with these settings. Throws UserError when it is refused. May be called by several threads at
/// once.
using ChangedNetlist = std::function<Network(const Overrides&)>;

/// The changes worth asking about: every processor, all those on which processes of one array run, and the links,
/// a tenth faster, twice as fast, and as fast as can be said (1 GHz, 1 Gbit/s); constants in cycles or bytes that
/// processes or processors have, a tenth less, half, none; one more of what the netlist's vals replicate.
std::vector<Change> changes_of(const Network&, const ChangedNetlist&);

/// The changed runs, in parallel on all cores; the shortest first. A change that the netlist refuses is left out.
std::vector<Answer> try_out(const std::vector<Change>&, const ChangedNetlist&, std::uint64_t seed, Time until);

} // namespace placedpar
