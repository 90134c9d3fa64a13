#pragma once

#include "text/diagnostic.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

/// These limits let the program refuse wrong input, such as a huge binary file, quickly. They are far above what a real
/// text needs.
inline constexpr std::size_t largest_source_bytes = 16 * 1024 * 1024;
inline constexpr std::size_t longest_source_line = 10000; ///< in bytes, without the line's end

struct LoadedSource {
    std::shared_ptr<const SourceFile> file; ///< never null, since messages quote a refused text, too
    std::vector<Diagnostic> problems;       ///< errors, without hints; empty if the text can be used
};

/// Reads a whole file. Reports a problem if the file is missing, a directory, a device, too large, or not text. A
/// Ctrl-Z ends the text, as in DOS.
LoadedSource load_source(const std::filesystem::path& path);
/// Reads a file as load_source() does; the path "-" means standard input (text/standard_streams.hpp). Standard input is
/// read once; later calls return the text of the first call.
LoadedSource load_input(const std::filesystem::path& path);
/// Loads the input that shown_input() shows as this text, such as the source path of a network.
LoadedSource load_shown_input(const std::string& shown_path);
/// Checks a text in memory as load_source() checks a file. `first_line` is above 1 if the text is a later piece of a
/// longer text.
LoadedSource check_source(std::string shown_path, std::string text, std::size_t first_line = 1);
/// Returns the reason why the path cannot be opened as a file or a pipe; "" if it can.
std::string why_not_a_file(const std::filesystem::path& path);

} // namespace placedpar
