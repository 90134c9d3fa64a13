#include "text/source.hpp"

#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace placedpar {

SourceFile::SourceFile(std::string shown_path, std::string text, std::size_t first_line)
    : path_(std::move(shown_path)), text_(std::move(text)), first_line_(first_line), line_starts_{0} {
    for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n')
            line_starts_.push_back(i + 1);
}

std::string_view SourceFile::line(std::size_t number) const {
    if (number < first_line_ || number - first_line_ >= line_starts_.size())
        return {};
    auto index = number - first_line_;
    auto start = line_starts_[index];
    auto end = index + 1 < line_starts_.size() ? line_starts_[index + 1] - 1 : text_.size();
    auto whole = std::string_view(text_).substr(start, end - start);
    if (whole.ends_with('\r'))
        whole.remove_suffix(1);
    return whole;
}

std::string Location::text() const {
    if (!file)
        return "";
    if (line == 0)
        return file->path();
    return fmt::format("{}:{}:{}", file->path(), line, column);
}

namespace {

bool is_in_word(char c, bool with_dots) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x80 && std::isalnum(byte) != 0) || c == '_' || (with_dots && c == '.');
}

/// Returns the number of bytes up to the closing quote, or of the whole rest if it is missing.
std::size_t length_in_quotes(std::string_view rest) {
    const auto closing = rest.find(rest.front(), 1);
    return closing == std::string_view::npos ? rest.size() : closing + 1;
}

std::size_t length_of_word(std::string_view rest, bool with_dots) {
    if (rest.empty())
        return 0;
    if (rest.front() == '"')
        return length_in_quotes(rest);
    std::size_t length = 0;
    while (length < rest.size() && is_in_word(rest[length], with_dots))
        ++length;
    while (length > 0 && rest[length - 1] == '.') // a dot at the end belongs to the text behind it
        --length;
    return length > 0 ? length : std::max<std::size_t>(first_character(rest).bytes, 1);
}

} // namespace

Location end_of_word(const Location& at) {
    if (!at.file || at.line == 0 || at.column == 0)
        return at;
    const std::string_view line = at.file->line(at.line);
    const std::string_view rest = line.substr(std::min(at.column - 1, line.size()));
    return {at.file, at.line, at.column + length_of_word(rest, !at.file->path().ends_with(".cfs"))};
}

} // namespace placedpar
