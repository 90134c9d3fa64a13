#pragma once

#include "netlist/read.hpp"
#include "text/source.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

class ProblemRegistry; // gaprocs/problem_registry.hpp

/// Describes a name of a netlist that a study can use, for completion in editors.
struct StudyName {
    std::string about = {}; ///< text in whole lines
    Location at = {};       ///< where the netlist declares the thing or gives the value; no file: unknown
    std::vector<std::string> choices = {}; ///< words that a setting can have as its value
};

/// The names of a netlist that a study can use.
struct StudyNames {
    /// Constants, "master.trials", and "trials" for all elements that have it.
    std::map<std::string, StudyName> settings;
    std::map<std::string, StudyName> measures; ///< without subscripts
    std::map<std::string, StudyName> programs; ///< the programs of processes
};

/// Reads the netlist as a study does. Returns nothing if the netlist has an error.
std::optional<StudyNames> names_for_study(const std::filesystem::path& netlist, const ReadOptions&, const Catalogue&,
                                          const ProblemRegistry&);

} // namespace placedpar
