#pragma once

#include "occam/language/parse.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// A program in occam that has been read and checked.
struct OccamCheck {
    std::unique_ptr<occam::Program> program;
    occam::SourceOptions options;             ///< options of the text and of the caller
    const occam::Declaration* main = nullptr; ///< the last procedure of the main file; null if there is none
    std::vector<Diagnostic> diagnostics = {};
    std::string not_shown = ""; ///< a line that says how many errors are not in `diagnostics`; "" if none
    bool failed = false;        ///< there are errors, so the program cannot be compiled
};

/// Reads and checks a program. Files that the program includes are looked for in PlacedPar's libraries and in these
/// folders. Checks that are off in `wanted` are skipped, as if the text turned them off. The text of `standard_input`
/// is what `#INCLUDE "standard input"` includes.
OccamCheck check_occam_source(std::shared_ptr<const SourceFile>, std::vector<std::filesystem::path> folders,
                              const occam::SourceOptions& wanted = {},
                              std::shared_ptr<const SourceFile> standard_input = nullptr);

} // namespace placedpar
