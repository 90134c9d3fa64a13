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

/// The netlist whose processes do the search.
struct NetlistAsked {
    std::filesystem::path path;
    Overrides overrides;
    ParsedNetlist parsed;         ///< the parsed file, which any number of searches can use
    std::filesystem::path output; ///< the file to be written, which must not be a file of the netlist
};

/// The first search of identify(), ready to run as the processes of a netlist.
struct ProcessSearch {
    ProblemRegistry problems; ///< "boom" and "boom-by-voltage", both the problem of the measured record
    Network network;
    std::vector<std::string> searches; ///< the processes that search, at least one
    std::size_t population = 0;        ///< number of individuals of all searches together
    std::size_t first = 0;             ///< samples before the first generation
    std::size_t trials = 0;            ///< generations after each further sample
    Coding coding = Coding::natural;

    /// Returns an observer that keeps each search's best individual of every generation.
    SearchAnswers answers() const;
};

/// Reads the netlist with the settings of the identification. A setting replaces the default of the parameter with the
/// same name in every searching process. If the netlist gives the parameter another value, the setting replaces the val
/// with the same name (population, elite), unless an override sets this val. A single search also uses the random
/// numbers of identify(). Several searches divide the population as the netlist says, and each search has its own
/// random numbers. The processes search the samples of `prepared`. Throws UserError if no process searches, if a search
/// belongs to a pair of a coarse and a fine search, or if the populations do not add up. Also throws UserError if the
/// output is an included file, if a setting cannot replace the netlist's value, or if the record has a gap.
ProcessSearch search_by_processes(const NetlistAsked& netlist, const identification::ComplianceSearch& prepared,
                                  const identification::IdentificationWay& way, const WarningSink&);

} // namespace placedpar
