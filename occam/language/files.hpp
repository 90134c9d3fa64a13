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

inline constexpr std::size_t deepest_files = 50;    ///< greatest depth of files that include or use other files
inline constexpr std::size_t deepest_nesting = 200; ///< greatest depth of nested constructs and parentheses

/// Describes a file that is being read, and the place where #INCLUDE or #USE names it.
struct OpenFile {
    std::string key; ///< the canonical path, or the name of a built-in file
    Location named_at;
};

/// Holds the state of reading an occam program with the files that it includes (#INCLUDE) and uses (#USE).
struct Reading {
    Program& program;
    const ParseOptions& options;
    Reporter& reporter;
    SourceOptions source_options = {};
    std::map<std::string, std::size_t> units = {}; ///< indices in Program::units; key: OpenFile::key
    std::vector<OpenFile> open = {};               ///< the files that are being read, beginning with the main file
    std::map<std::string, std::string> defined =
        {}; ///< names that the preprocessor's #DEFINE has defined, with their values
    std::set<std::string, std::less<>> refused =
        {};                ///< unsupported words of the language that have been reported; each is reported only once
    std::size_t depth = 0; ///< depth of nesting, across files

    Location location(const Place& place) const { return program.location(place); }
};

enum class FileUse : std::uint8_t { include, use };

struct FoundFile {
    std::string key;
    std::shared_ptr<const SourceFile> file; ///< null if the file has been refused
};

/// Finds a file that #INCLUDE or #USE names. Searches the folder of the file that names it, then the folders of the
/// options, then the files that are built into PlacedPar. For a library, searches the built-in files first. Reports an
/// error if the file does not exist, if it is being read already, or if files include or use each other too deeply.
std::optional<FoundFile> find_file(Reading&, const std::string& name, FileUse, const Place& named_at);

/// Adds a file to the program, and returns its index.
std::uint32_t add_file(Reading&, std::shared_ptr<const SourceFile>, const Location& named_at);

} // namespace placedpar::occam
