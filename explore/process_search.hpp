#pragma once

#include "explore/load.hpp"
#include "gaprocs/problem_registry.hpp"
#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace placedpar {

/// What processes are to search.
struct NetlistAsked {
    std::filesystem::path path;
    Overrides overrides;
    ReadOptions options;
    std::filesystem::path output; ///< the file to be written, which must not be a file of the netlist
};

/// The first search of identify(), ready to run as the processes of a netlist.
struct ProcessSearch {
    ProblemRegistry problems; ///< "boom" is what the record asks
    Network network;
    std::string master; ///< the process that searches

    /// What it found. REQUIRES: the report of a run of the network that was completed.
    std::vector<double> compliances(const RunReport& report) const;
};

/// Hands the way over to the netlist: what its processes leave to their defaults, and what it has a val of the same
/// name for (population, elite), unless an override sets it. The processes know neither gaps nor a gate; they are sent
/// the samples up to where the gate froze the search for good.
/// Throws UserError for what cannot be the same search: another number of searching processes
/// than one, an output that is an included file, a setting that the netlist fixes otherwise, a gap.
ProcessSearch search_by_processes(const NetlistAsked& netlist, const identification::ComplianceSearch& prepared,
                                  const identification::IdentificationWay& way, const WarningSink&);

} // namespace placedpar
