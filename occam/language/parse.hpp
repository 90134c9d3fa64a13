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

/// Holds the options for reading an occam program.
struct ParseOptions {
    std::vector<std::filesystem::path>
        folders; ///< searched for files that #INCLUDE and #USE name, after the folder of the file that names them
    /// Returns the text of a file or library that is built into PlacedPar, such as "hostio.inc"; nothing if there is
    /// none. REQUIRES: the name has no path and no capital letters.
    std::function<std::optional<std::string>(const std::string& name)> built_in;
    std::vector<std::string> defined; ///< names that are defined for the preprocessor's #IF
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

/// Parses an occam file, and all files that it includes or uses. Reports errors; the returned tree then lacks the parts
/// with errors.
Parsed parse(std::shared_ptr<const SourceFile>, const ParseOptions&, Reporter&);

} // namespace placedpar::occam
