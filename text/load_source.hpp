#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// Limits that keep invalid input from costing time: far above what a written or generated text needs.
inline constexpr std::size_t largest_source_bytes = 16 * 1024 * 1024;
inline constexpr std::size_t longest_source_line = 10000; ///< bytes, without the line's end

struct LoadedSource {
    std::shared_ptr<const SourceFile> file; ///< never null, since messages quote a refused text, too
    std::vector<Diagnostic> problems;       ///< errors, without hints; empty: the text is good
};

/// Reads a whole file. A missing file, a directory, a device, a file that is too large or not text is a
/// problem. A Ctrl-Z ends the text, as it does in DOS.
LoadedSource load_source(const std::filesystem::path& path);
/// Does what load_source() does, but "-" is standard input (text/standard_streams.hpp), which is read once; later calls
/// return the same text.
LoadedSource load_input(const std::filesystem::path& path);
/// Makes the checks of load_source() on a text in memory, or on a piece of a text.
LoadedSource check_source(std::string shown_path, std::string text, std::size_t first_line = 1);
/// Returns "" if the path can be opened as a file or a pipe, else the reason why it cannot.
std::string why_not_a_file(const std::filesystem::path& path);

} // namespace placedpar
