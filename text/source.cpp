#include "text/source.hpp"

#include <fmt/format.h>

namespace placedpar {

SourceFile::SourceFile(std::string shown_path, std::string text)
    : path_(std::move(shown_path)), text_(std::move(text)), line_starts_{0} {
    for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n')
            line_starts_.push_back(i + 1);
}

std::string_view SourceFile::line(std::size_t number) const {
    if (number == 0 || number > line_starts_.size())
        return {};
    auto start = line_starts_[number - 1];
    auto end = number < line_starts_.size() ? line_starts_[number] - 1 : text_.size();
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
