#pragma once

#include "occam/language/parse.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar::occam {

inline constexpr std::size_t deepest_files = 50;    ///< files within files
inline constexpr std::size_t deepest_nesting = 200; ///< constructs and parentheses within each other

/// A file that is being read, and the place at which another file names it.
struct OpenFile {
    std::string key; ///< the canonical path, or the name of a built-in file
    Location named_at;
};

/// The files of a program while they are read.
struct Reading {
    Program& program;
    const ParseOptions& options;
    Reporter& reporter;
    SourceOptions source_options = {};
    std::map<std::string, std::size_t> units = {};   ///< by key
    std::vector<OpenFile> open = {};                 ///< the main file first
    std::map<std::string, std::string> defined = {}; ///< names of the preprocessor with their values
    std::set<std::string, std::less<>> refused = {}; ///< words that have been refused; each word is refused only once
    std::size_t depth = 0;                           ///< depth of nesting, across files

    Location location(const Place& place) const { return program.location(place); }
};

enum class FileUse : std::uint8_t { include, use };

struct FoundFile {
    std::string key;
    std::shared_ptr<const SourceFile> file; ///< null if the file has been refused
};

/// Looks for a file that is named at a place: beside the file that names it, in the folders, then among PlacedPar's own
/// files; a library is first looked for among these. Reports an error if the file does not exist, if it is already
/// open, or if files are nested too deeply.
std::optional<FoundFile> find_file(Reading&, const std::string& name, FileUse, const Place& named_at);

/// Adds a file to the program, and returns its index.
std::uint32_t add_file(Reading&, std::shared_ptr<const SourceFile>, const Location& named_at);

} // namespace placedpar::occam
