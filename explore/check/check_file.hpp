#pragma once

#include "netlist/read.hpp"
#include "occam/language/parse.hpp"
#include "text/positions.hpp"

#include <boost/json/fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace placedpar {

/// Returns whether the file's name is that of a study, a file of TOML that describes many runs of a netlist.
bool is_study(const std::filesystem::path&);

/// The options with which a file is checked. Options for other languages have no effect.
struct CheckOptions {
    Overrides set = {};                ///< settings of a netlist
    ReadOptions read = {};             ///< options for reading a netlist; for a program only the folders are used
    occam::SourceOptions program = {}; ///< the checks of a program
};

struct CheckedFile {
    std::string language;                   ///< "netlist" (also for a configuration), "occam" or "study"
    std::vector<Diagnostic> diagnostics;    ///< at most 20 errors
    std::string not_shown = "";             ///< a line that says how many errors are not in `diagnostics`; "" if none
    std::string summary = "";               ///< a line that summarises the contents; "" if the file has an error
    std::vector<std::string> included = {}; ///< paths of the files that the checked file includes, as far as they are
                                            ///< known
    NamesOf names = NamesOf::occam;         ///< language in which the diagnostics name things

    bool failed() const { return has_errors(diagnostics); }
};

/// Reads and checks a netlist, an occam configuration, a program in occam or a study, according to the file's name. "-"
/// is a netlist from standard input. For a study, also checks the netlist with the settings of the first run. If a text
/// in memory replaces a file (text/texts_in_memory.hpp), reads this text. Errors of the file are in the result, not
/// thrown.
CheckedFile check_file(const std::filesystem::path&, const Catalogue&, const CheckOptions&);

/// Returns {"severity", "file", "line", "column", "end_line", "end_column", "message", "hint", "also"}. Lines and
/// columns count from 1, columns in bytes. The end is the column after the last character. A fault of a whole file has
/// no line. "also" lists related places, such as the first of two declarations. Related places have no severity and no
/// hint.
boost::json::object diagnostic_json(const Diagnostic&, NamesOf);
/// Returns {"file", "language", "valid", "summary", "diagnostics", "not_shown"}.
boost::json::object checked_json(const std::filesystem::path&, const CheckedFile&);

} // namespace placedpar
