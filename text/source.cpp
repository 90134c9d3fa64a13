#include "text/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

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

namespace {

bool is_text(char c) {
    auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 ? byte != 0x7f : (c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v');
}

SourceProblem not_a_text(std::string_view text, std::size_t offset) {
    auto before = text.substr(0, offset);
    auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    auto start = before.rfind('\n');
    auto column = start == std::string_view::npos ? offset + 1 : offset - start;
    return {fmt::format("this is no text but a binary file: it holds the byte 0x{:02x}",
                        static_cast<unsigned char>(text[offset])),
            line, column};
}

LoadedSource refused(std::string shown_path, std::string message) {
    return {std::make_shared<SourceFile>(std::move(shown_path), ""), {{std::move(message)}}};
}

/// "" where the path can be opened as a file.
std::string why_not_a_file(const std::filesystem::path& path) {
    std::error_code error;
    auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        return "there is no such file";
    if (status.type() == std::filesystem::file_type::directory)
        return "this is a directory, not a file";
    if (status.type() == std::filesystem::file_type::none || status.type() == std::filesystem::file_type::unknown)
        return "the file cannot be read: " + error.message();
    if (status.type() != std::filesystem::file_type::regular)
        return "this is no regular file";
    return "";
}

} // namespace

LoadedSource check_source(std::string shown_path, std::string text) {
    if (text.starts_with("\xef\xbb\xbf"))
        text.erase(0, 3);
    if (text.size() > largest_source_bytes)
        return refused(std::move(shown_path),
                       fmt::format("the file is too large: it may have {} bytes", largest_source_bytes));
    LoadedSource loaded{std::make_shared<SourceFile>(std::move(shown_path), std::move(text)), {}};
    const auto& all = loaded.file->text();
    auto odd = std::find_if_not(all.begin(), all.end(), is_text);
    if (odd != all.end()) {
        loaded.problems.push_back(not_a_text(all, static_cast<std::size_t>(odd - all.begin())));
        return loaded;
    }
    std::size_t number = 1;
    for (std::size_t start = 0; start < all.size(); ++number) {
        auto end = std::min(all.find('\n', start), all.size());
        if (end - start > longest_source_line) {
            loaded.problems.push_back({fmt::format("the line is too long: it has {} characters, {} are allowed",
                                                   end - start, longest_source_line),
                                       number, longest_source_line + 1});
            return loaded;
        }
        start = end + 1;
    }
    return loaded;
}

LoadedSource load_source(const std::filesystem::path& path) {
    if (auto why = why_not_a_file(path); !why.empty())
        return refused(path.string(), why);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return refused(path.string(), "the file cannot be opened for reading");
    std::string text;
    std::array<char, 1 << 16> piece;
    while (text.size() <= largest_source_bytes + 3 && in) { // three bytes may be a byte order mark
        in.read(piece.data(), piece.size());
        text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad())
        return refused(path.string(), "the file cannot be read to its end");
    text.shrink_to_fit(); // it is kept for as long as anybody may have to show a line of it
    return check_source(path.string(), std::move(text));
}

} // namespace placedpar
