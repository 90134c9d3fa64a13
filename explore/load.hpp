#pragma once

#include "hydraulics/data/record.hpp"
#include "netlist/read.hpp"
#include "text/diagnostic.hpp"
#include "text/source.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

class ProblemRegistry; // gaprocs/problem_registry.hpp
namespace hydraulics {
class Parameters;   // hydraulics/data/parameters.hpp
struct RecordNeeds; // hydraulics/data/record_table.hpp
} // namespace hydraulics

// Functions that read the user's files. For a file with errors they throw RefusedInput, which shows each error with
// file, line, column and a caret. "-" is standard input.

/// The largest number of errors shown, and the largest number of warnings shown.
inline constexpr std::size_t most_faults_shown = 20;

/// A function that receives a file's warnings as text in whole lines.
using WarningSink = std::function<void(const std::string&)>;

/// Reads a text. Throws RefusedInput.
std::shared_ptr<const SourceFile> load_text(const std::filesystem::path&);

/// Reads a netlist that may use all kinds of processes that this program knows. Throws RefusedInput.
Network load_network(const std::filesystem::path&, const Overrides&, const ProblemRegistry&, const WarningSink&,
                     const ReadOptions& = {});
/// Makes the network of a parsed netlist, with the kinds of processes in a catalogue. Throws RefusedInput.
Network load_network(const ParsedNetlist&, const Overrides&, const Catalogue&, const WarningSink&);

/// A record of measurements, and the warnings about its file.
struct LoadedRecord {
    hydraulics::Record record;
    std::vector<Diagnostic> warnings;
};
/// Reads a record of measurements. Throws RefusedInput.
LoadedRecord load_record(const std::filesystem::path&, const hydraulics::RecordNeeds&, const WarningSink&);

/// Returns the excavator's constants. Constants in the file replace the program's constants of the same name. An empty
/// path gives the program's constants. Throws RefusedInput.
hydraulics::Parameters load_machine(const std::filesystem::path&, const WarningSink&);

} // namespace placedpar
