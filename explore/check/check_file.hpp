#pragma once

#include "netlist/read.hpp"
#include "occam/language/parse.hpp"
#include "text/positions.hpp"

#include <boost/json/fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace placedpar {

/// Returns whether a file is a study, by its name.
bool is_study(const std::filesystem::path&);

/// The options with which a file is checked. Those that do not suit its language have no effect.
struct CheckOptions {
    Overrides set = {};                ///< of a netlist
    ReadOptions read = {};             ///< of a netlist; of a program only the folders
    occam::SourceOptions program = {}; ///< the checks of a program
};

struct CheckedFile {
    std::string language;                   ///< "netlist" (also of a configuration), "occam" or "study"
    std::vector<Diagnostic> diagnostics;    ///< at most 20 errors
    std::string not_shown = "";             ///< a line that says how many errors are not in `diagnostics`; "" if none
    std::string summary = "";               ///< a line that says what the file has; "" if it has an error
    std::vector<std::string> included = {}; ///< paths of the files that were read with it, as far as they are known
    NamesOf names = NamesOf::occam;         ///< in the files that the diagnostics are about

    bool failed() const { return has_errors(diagnostics); }
};

/// Reads and checks a netlist, a configuration, a program in occam or a study, as the file's name says; "-" is a
/// netlist from standard input. Of a study, the netlist is checked too, with the settings of its first run. Reads texts
/// in memory in place of files (text/texts_in_memory.hpp). Everything that is wrong with the file is in the result.
CheckedFile check_file(const std::filesystem::path&, const Catalogue&, const CheckOptions&);

/// Returns {"severity", "file", "line", "column", "end_line", "end_column", "message", "hint", "also"}. Lines and
/// columns count from 1, columns in bytes. The end is behind the last character. A fault of a file as a whole has no
/// line. "also" lists the second places, which have the same keys except severity and hint.
boost::json::object diagnostic_json(const Diagnostic&, NamesOf);
/// Returns {"file", "language", "valid", "summary", "diagnostics", "not_shown"}.
boost::json::object checked_json(const std::filesystem::path&, const CheckedFile&);

} // namespace placedpar
