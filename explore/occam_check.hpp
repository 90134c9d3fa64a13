#pragma once

#include "occam/check/check.hpp"
#include "occam/language/parse.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

class Reporter; // text/reporter.hpp
namespace occam {
struct Configured; // occam/configuration/configured.hpp
} // namespace occam

/// A program in occam, or a configuration, that has been read and checked.
struct OccamCheck {
    std::unique_ptr<occam::Program> program;
    occam::SourceOptions options;             ///< options that the text or the caller sets
    const occam::Declaration* main = nullptr; ///< the last procedure of the main file; null if there is none
    std::vector<Diagnostic> diagnostics = {};
    std::string not_shown = ""; ///< a line that says how many errors are not in `diagnostics`; "" if none
    bool failed = false;        ///< there are errors, so the program cannot be compiled
    bool parsed = false;        ///< the text has no errors of syntax, so the meanings of names in `program` are known
    std::shared_ptr<const occam::Configured> configured = {}; ///< null unless a configuration was parsed
};

/// Reads and checks a program. Files that the program includes are looked for in PlacedPar's libraries and in these
/// folders. Skips the checks that `wanted` turns off. A program can include the text of `standard_input` by `#INCLUDE
/// "standard input"`. `change` is passed to occam::check(). The reporter receives the diagnostics; without a reporter,
/// the result has them.
OccamCheck check_occam_source(std::shared_ptr<const SourceFile>, std::vector<std::filesystem::path> folders,
                              const occam::SourceOptions& wanted = {},
                              std::shared_ptr<const SourceFile> standard_input = nullptr,
                              const occam::ChangeDeclaration& change = {});
OccamCheck check_occam_source(std::shared_ptr<const SourceFile>, std::vector<std::filesystem::path> folders,
                              const occam::SourceOptions& wanted, Reporter&,
                              std::shared_ptr<const SourceFile> standard_input = nullptr,
                              const occam::ChangeDeclaration& change = {});
/// Reads a configuration. The files of its processes are not compiled.
OccamCheck check_configuration_source(std::shared_ptr<const SourceFile>);

} // namespace placedpar
