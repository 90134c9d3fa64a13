#pragma once

#include "explore/load.hpp"
#include "explore/search_answers.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/problem_registry.hpp"
#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace placedpar {

/// The netlist whose processes are to search.
struct NetlistAsked {
    std::filesystem::path path;
    Overrides overrides;
    ParsedNetlist parsed;         ///< the file's text, for any number of searches
    std::filesystem::path output; ///< the file to be written, which must not be a file of the netlist
};

/// The first search of identify(), ready to run as the processes of a netlist.
struct ProcessSearch {
    ProblemRegistry problems; ///< "boom" and "boom-by-voltage" are the problem of the record
    Network network;
    std::vector<std::string> searches; ///< the processes that search, at least one
    std::size_t population = 0;        ///< individuals of all searches together
    std::size_t first = 0;             ///< samples before the first generation
    std::size_t trials = 0;            ///< generations after each further sample
    Coding coding = Coding::natural;

    /// Returns an observer that keeps the answers of the searches.
    SearchAnswers answers() const;
};

/// Passes the settings of the identification to the netlist: to parameters that its processes leave to their defaults,
/// and to vals of the same name (population, elite) unless an override sets them. A single search also gets the random
/// numbers of identify(). Several searches divide the population as the netlist says, and each search has its own
/// random numbers. The processes handle neither gaps nor the gate, so they get only the samples before the gate froze
/// the search for good. Throws UserError if the netlist cannot make the search: no process searches, a searching
/// process is one of a pair, or the populations do not add up. Also throws UserError if the output is an included file,
/// the netlist fixes a setting to another value, or the record has a gap.
ProcessSearch search_by_processes(const NetlistAsked& netlist, const identification::ComplianceSearch& prepared,
                                  const identification::IdentificationWay& way, const WarningSink&);

} // namespace placedpar
