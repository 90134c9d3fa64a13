#include "text/source.hpp"

#include <fmt/format.h>

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

} // namespace placedpar
