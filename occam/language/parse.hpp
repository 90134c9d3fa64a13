#pragma once

#include "occam/language/tree.hpp"
#include "text/reporter.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Holds the options for reading a program.
struct ParseOptions {
    std::vector<std::filesystem::path>
        folders; ///< folders for #INCLUDE and #USE, searched after the folder of the file that names the other file
    /// Returns the text of one of PlacedPar's own files or libraries, such as "hostio.inc"; nothing if there is none.
    /// The name has no path, and only small letters.
    std::function<std::optional<std::string>(const std::string& name)> built_in;
    std::vector<std::string> defined; ///< names that are defined for the preprocessor
};

/// Holds the options that #OPTION and #PRAGMA set in the main file.
struct SourceOptions {
    bool alias_checks = true, usage_checks = true, range_checks = true, run_time_checks = true;
    bool vector_space = true;
};

struct Parsed {
    std::unique_ptr<Program> program;
    SourceOptions options;
};

/// Reads a file, and all files that it includes or uses. Reports errors; the tree then has only the parts without
/// errors.
Parsed parse(std::shared_ptr<const SourceFile>, const ParseOptions&, Reporter&);

} // namespace placedpar::occam
