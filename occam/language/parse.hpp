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

/// Options of reading.
struct ParseOptions {
    std::vector<std::filesystem::path> folders; ///< where #INCLUDE and #USE look, after the folder of the file
    /// Returns the text of one of PlacedPar's own files or libraries, such as "hostio.inc"; nothing if there is none.
    /// The name is without its path, in small letters.
    std::function<std::optional<std::string>(const std::string& name)> built_in;
    std::vector<std::string> defined; ///< names of the preprocessor
};

/// The options that #OPTION and #PRAGMA set in the main file.
struct SourceOptions {
    bool alias_checks = true, usage_checks = true, range_checks = true, run_time_checks = true;
    bool vector_space = true;
};

struct Parsed {
    std::unique_ptr<Program> program;
    SourceOptions options;
};

/// Reads a file with all that it includes and uses. Reports errors; the tree then has the parts that could be read.
Parsed parse(std::shared_ptr<const SourceFile>, const ParseOptions&, Reporter&);

} // namespace placedpar::occam
