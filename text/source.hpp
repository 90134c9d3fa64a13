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
