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

/// The netlist whose processes search for the compliances of an excavator in a record of measurements.
struct NetlistAsked {
    std::filesystem::path path;
    Overrides overrides;
    ParsedNetlist parsed;         ///< the parsed file, which any number of searches can use
    std::filesystem::path output; ///< the file to be written, which must not be a file of the netlist
};

/// The first search of identify() (identification of the compliances), ready to run as the processes of a netlist.
struct ProcessSearch {
    ProblemRegistry problems; ///< the problem of the measured record, under the two names that netlists use: "boom" and
                              ///< "boom-by-voltage"
    Network network;
    std::vector<std::string> searches; ///< names of the processes that search, at least one
    std::size_t population = 0;        ///< number of individuals in all searches together
    std::size_t first = 0;             ///< number of samples before the first generation
    std::size_t trials = 0;            ///< number of generations after each further sample
    Coding coding = Coding::natural;

    /// Returns an observer that keeps each search's best individual of every generation.
    SearchAnswers answers() const;
};

/// Reads the netlist so that its processes search for the compliances that fit the samples of `prepared`. They have the
/// settings of the identification, such as the number of individuals.
///
/// 1. Each setting becomes the default of the parameter with the same name, in every searching process.
/// 2. If the netlist itself states another value for this parameter, this value should come from a constant (`val`)
/// with the same name, such as `population` or `elite`. The setting then replaces the value of this constant, as --set
/// would.
/// 3. A netlist with a single search also uses the random numbers of identify(). If there are several searches, the
/// netlist states the population of each, and each has its own random numbers.
///
/// Throws UserError if no process searches, if a search belongs to a pair of a coarse and a fine search, or if the
/// populations do not add up to the population of the identification. Also throws UserError if the output is an
/// included file, or if the record has a gap. Throws RefusedInput if the value still differs from the setting, because
/// there is no such constant, an override already sets the constant, or the constant does not determine the parameter.
ProcessSearch search_by_processes(const NetlistAsked& netlist, const identification::ComplianceSearch& prepared,
                                  const identification::IdentificationWay& way, const WarningSink&);

} // namespace placedpar
