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

inline constexpr std::size_t deepest_files = 50;    ///< depth of files that include or use other files
inline constexpr std::size_t deepest_nesting = 200; ///< depth of nested constructs and parentheses

/// Describes a file that is being read, and the place where another file names it.
struct OpenFile {
    std::string key; ///< the canonical path, or the name of a built-in file
    Location named_at;
};

/// Holds the state of reading the files of a program.
struct Reading {
    Program& program;
    const ParseOptions& options;
    Reporter& reporter;
    SourceOptions source_options = {};
    std::map<std::string, std::size_t> units = {};   ///< by key
    std::vector<OpenFile> open = {};                 ///< the main file first
    std::map<std::string, std::string> defined = {}; ///< names of the preprocessor with their values
    std::set<std::string, std::less<>> refused =
        {};                ///< words of the language that have been refused; each is refused only once
    std::size_t depth = 0; ///< depth of nesting, across files

    Location location(const Place& place) const { return program.location(place); }
};

enum class FileUse : std::uint8_t { include, use };

struct FoundFile {
    std::string key;
    std::shared_ptr<const SourceFile> file; ///< null if the file has been refused
};

/// Looks for a file that is named at a place. Searches the folder of the file that names it, then the folders of the
/// options, then PlacedPar's own files. For a library, searches PlacedPar's own files first. Reports an error if the
/// file does not exist, if it is already open, or if files are nested too deeply.
std::optional<FoundFile> find_file(Reading&, const std::string& name, FileUse, const Place& named_at);

/// Adds a file to the program, and returns its index.
std::uint32_t add_file(Reading&, std::shared_ptr<const SourceFile>, const Location& named_at);

} // namespace placedpar::occam
