#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// These limits keep invalid input from costing time. They are far above what a written or generated text needs.
inline constexpr std::size_t largest_source_bytes = 16 * 1024 * 1024;
inline constexpr std::size_t longest_source_line = 10000; ///< bytes, without the line's end

struct LoadedSource {
    std::shared_ptr<const SourceFile> file; ///< never null, since messages also quote a refused text
    std::vector<Diagnostic> problems;       ///< errors, without hints; empty: the text is good
};

/// Reads a whole file. It is a problem if the file is missing, a directory, a device, too large, or not text. A Ctrl-Z
/// ends the text, as it does in DOS.
LoadedSource load_source(const std::filesystem::path& path);
/// Does what load_source() does, but "-" is standard input (text/standard_streams.hpp). Standard input is read once;
/// later calls return the same text.
LoadedSource load_input(const std::filesystem::path& path);
/// Loads the input that shown_input() shows as this text, such as the source path of a network.
LoadedSource load_shown_input(const std::string& shown_path);
/// Checks a text in memory, or a piece of a text, as load_source() checks a file.
LoadedSource check_source(std::string shown_path, std::string text, std::size_t first_line = 1);
/// Returns "" if the path can be opened as a file or a pipe, else the reason why it cannot.
std::string why_not_a_file(const std::filesystem::path& path);

} // namespace placedpar
