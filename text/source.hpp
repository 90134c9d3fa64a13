#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// One text that a netlist is read from: a file, or a text without a file such as "--set".
class SourceFile {
public:
    SourceFile(std::string shown_path, std::string text);

    /// The path as people should see it in a message.
    const std::string& path() const { return path_; }
    const std::string& text() const { return text_; }
    /// The text of a line, counted from 1, without its line end; empty beyond the last.
    std::string_view line(std::size_t number) const;

private:
    std::string path_;
    std::string text_;
    std::vector<std::size_t> line_starts_;
};

/// A place in a source. Lines and columns count from 1; a column counts bytes. Line 0 is the file as a
/// whole; without a file it is no place at all.
struct Location {
    std::shared_ptr<const SourceFile> file;
    std::size_t line = 0;
    std::size_t column = 0;

    /// "path:line:column", as far as it is known.
    std::string text() const;
};

/// Bounds that keep rubbish from costing time: far above what a netlist written by hand or generated needs.
inline constexpr std::size_t largest_source_bytes = 16 * 1024 * 1024;
inline constexpr std::size_t longest_source_line = 10000;

/// A source that cannot be read or is no text; `column` and `line` say where, line 0 for the whole file.
struct SourceProblem {
    std::string message;
    std::size_t line = 0;
    std::size_t column = 0;
};

struct LoadedSource {
    std::shared_ptr<const SourceFile> file; ///< there even when the text is refused, so that it can be shown
    std::vector<SourceProblem> problems;    ///< empty: the text is good
};

/// Reads a whole file. A missing file, a directory, a device, one that is too large or is no text is a
/// problem.
LoadedSource load_source(const std::filesystem::path& path);
/// The same checks of a text that is there already.
LoadedSource check_source(std::string shown_path, std::string text);

} // namespace placedpar
