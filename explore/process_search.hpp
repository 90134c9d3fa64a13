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

/// The netlist whose processes are to search.
struct NetlistAsked {
    std::filesystem::path path;
    Overrides overrides;
    ReadOptions options;
    std::filesystem::path output; ///< the file to be written, which must not be a file of the netlist
};

/// The first search of identify(), ready to run as the processes of a netlist.
struct ProcessSearch {
    ProblemRegistry problems; ///< "boom" is the problem of the record
    Network network;
    std::string master; ///< the process that searches

    /// Returns the compliances that the search found. REQUIRES: the report of a completed run of the network.
    std::vector<double> compliances(const RunReport& report) const;
};

/// Passes the settings of the identification to the netlist. It sets the parameters that processes leave to their
/// defaults, and the vals of the same name (population, elite) unless an override sets them. The processes handle
/// neither gaps nor the gate, so they get only the samples before the gate freezes the search for good. Throws
/// UserError if the netlist cannot make the same search. It then lacks a single searching process, the output is an
/// included file, the netlist fixes a setting to another value, or the record has a gap.
ProcessSearch search_by_processes(const NetlistAsked& netlist, const identification::ComplianceSearch& prepared,
                                  const identification::IdentificationWay& way, const WarningSink&);

} // namespace placedpar
