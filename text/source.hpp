#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A text that is read: of a file, or without one, such as what stands behind "--set".
class SourceFile {
public:
    /// A piece of a longer text begins at a later line than the first.
    SourceFile(std::string shown_path, std::string text, std::size_t first_line = 1);

    /// The path as people should see it in a message.
    const std::string& path() const { return path_; }
    const std::string& text() const { return text_; }
    std::size_t first_line() const { return first_line_; }
    /// The text of a line, counted from 1, without its line end; empty before the first and beyond the last.
    std::string_view line(std::size_t number) const;

private:
    std::string path_;
    std::string text_;
    std::size_t first_line_;
    std::vector<std::size_t> line_starts_;
};

/// A place in a source. Lines and columns count from 1; a column counts bytes. Line 0 is the source as a whole. Without
/// a file it is a place in a text whose name only the caller knows, or, with line 0, no place at all.
struct Location {
    std::shared_ptr<const SourceFile> file;
    std::size_t line = 0;
    std::size_t column = 0;

    /// "path:line:column", or the path alone for line 0; "" without a file.
    std::string text() const;

    bool operator==(const Location&) const = default;
};

} // namespace placedpar
