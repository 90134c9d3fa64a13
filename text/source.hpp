#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// The text of a file, or of something else to which messages refer, such as the argument of the option "--set".
class SourceFile {
public:
    /// `shown_path` is the name in messages. `first_line` is the number of the text's first line; above 1 if the text
    /// is a later piece of a longer text.
    SourceFile(std::string shown_path, std::string text, std::size_t first_line = 1);

    /// Returns the path as messages show it.
    const std::string& path() const { return path_; }
    const std::string& text() const { return text_; }
    std::size_t first_line() const { return first_line_; }
    /// Returns a line, counted from 1, without its newline; "" for a number before the first line or after the last.
    std::string_view line(std::size_t number) const;

private:
    std::string path_;
    std::string text_;
    std::size_t first_line_;
    std::vector<std::size_t> line_starts_;
};

/// A place in a source. Lines and columns count from 1; columns count bytes. Line 0 means the source as a whole. A
/// location without a file and with a line is for readers that do not know the name of their file. A location without a
/// file and with line 0 is empty.
struct Location {
    std::shared_ptr<const SourceFile> file;
    std::size_t line = 0;
    std::size_t column = 0;

    /// Returns "path:line:column", or the path alone for line 0; "" if there is no file.
    std::string text() const;

    bool operator==(const Location&) const = default;
};

} // namespace placedpar
