#include "text/load_source.hpp"

#include "text/standard_streams.hpp"
#include "text/texts_in_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

namespace placedpar {

namespace {

using File = std::shared_ptr<const SourceFile>;

bool is_text(char c) {
    auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 ? byte != 0x7f : (c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v');
}

/// Returns whether a byte occurs only in binary files. Bells, backspaces and escapes do not count, since texts that
/// were copied from a terminal have them.
bool is_of_binary_file(char c) { return !is_text(c) && c != '\a' && c != '\b' && c != '\x1b'; }

Diagnostic problem_at(const File& file, std::size_t line, std::size_t column, std::string message) {
    return {.severity = Severity::error, .message = std::move(message), .location = {file, line, column}};
}

/// Reports the first byte that cannot be in a text.
std::optional<Diagnostic> binary_problem(const File& file) {
    const std::string& text = file->text();
    auto odd = std::ranges::find_if_not(text, is_text);
    if (odd == text.end())
        return std::nullopt;
    auto line = static_cast<std::size_t>(std::count(text.begin(), odd, '\n')) + file->first_line();
    auto start = std::find(std::make_reverse_iterator(odd), text.rend(), '\n').base();
    auto byte = fmt::format("0x{:02x}", static_cast<unsigned char>(*odd));
    return problem_at(file, line, static_cast<std::size_t>(odd - start) + 1,
                      std::ranges::any_of(text, is_of_binary_file)
                          ? "this is a binary file, not text: it contains the byte " + byte
                          : "the control character " + byte + " is not allowed in a text: remove it");
}

/// Returns whether the text is UTF-16. Without a byte order mark, the text counts as UTF-16 if every second byte at its
/// beginning is 0, as it is for Latin letters.
bool is_utf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return true;
    auto zeros = [text](std::size_t first) {
        return text.size() >= 8 && text[first] == 0 && text[first + 2] == 0 && text[first + 4] == 0 &&
               text[1 - first] != 0 && text[3 - first] != 0 && text[5 - first] != 0;
    };
    return zeros(0) || zeros(1);
}

/// Reports the first line that is too long.
std::optional<Diagnostic> long_line_problem(const File& file) {
    const std::string& text = file->text();
    std::size_t number = file->first_line();
    for (std::size_t start = 0; start < text.size(); ++number) {
        auto end = std::min(text.find('\n', start), text.size());
        if (std::string_view line = file->line(number);
            line.size() > longest_source_line && line.find('\r') < line.npos)
            return problem_at(file, number, line.find('\r') + 1,
                              "the lines end in carriage returns only, not in LF or CR LF: tr '\\r' '\\n' < FILE > NEW "
                              "converts the file");
        if (auto bytes = file->line(number).size(); bytes > longest_source_line)
            return problem_at(file, number, longest_source_line + 1,
                              fmt::format("the line is too long: it has {} bytes, but at most {} bytes are allowed",
                                          bytes, longest_source_line));
        start = end + 1;
    }
    return std::nullopt;
}

LoadedSource refused(std::string shown_path, std::string message) {
    auto file = std::make_shared<const SourceFile>(std::move(shown_path), "");
    return {file, {problem_at(file, 0, 0, std::move(message))}};
}

} // namespace

std::string why_not_a_file(const std::filesystem::path& path) {
    std::error_code error;
    auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        return "this file does not exist";
    if (status.type() == std::filesystem::file_type::directory)
        return "this is a directory, not a file";
    if (status.type() == std::filesystem::file_type::none || status.type() == std::filesystem::file_type::unknown)
        return "the file cannot be read: " + error.message();
    bool can_be_read = status.type() == std::filesystem::file_type::regular ||
                       status.type() == std::filesystem::file_type::fifo; // such as from a shell's <(...)
    return can_be_read ? "" : "this is neither a file nor a pipe";
}

LoadedSource check_source(std::string shown_path, std::string text, std::size_t first_line) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    constexpr char end_of_file_in_dos = '\x1a'; // Ctrl-Z, often followed by old data of the disk's block
    if (first_line == 1 && is_utf16(text))
        return refused(std::move(shown_path), "the file is UTF-16, expected UTF-8 or ASCII: iconv -f UTF-16 -t UTF-8 "
                                              "FILE > NEW converts it");
    if (text.starts_with(byte_order_mark))
        text.erase(0, byte_order_mark.size());
    if (auto end = text.find(end_of_file_in_dos); end != std::string::npos)
        text.erase(end);
    if (text.size() > largest_source_bytes)
        return refused(std::move(shown_path),
                       fmt::format("the file is too large: at most {} bytes are allowed", largest_source_bytes));
    auto file = std::make_shared<const SourceFile>(std::move(shown_path), std::move(text), first_line);
    auto problem = binary_problem(file);
    if (!problem)
        problem = long_line_problem(file);
    return {file, problem ? std::vector{std::move(*problem)} : std::vector<Diagnostic>{}};
}

namespace {

LoadedSource read_source(std::istream& in, const std::string& shown_path) {
    std::string text;
    std::array<char, 1 << 16> piece;
    while (text.size() <= largest_source_bytes + 3 && in) { // 3 bytes more, for a byte order mark, which does not count
        in.read(piece.data(), piece.size());
        text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad())
        return refused(shown_path, "the file cannot be read to its end");
    text.shrink_to_fit(); // the text is kept as long as a message may quote one of its lines
    return check_source(shown_path, std::move(text));
}

/// Reads standard input. Empty input is an error: the command before the pipe has failed, or there is no pipe.
LoadedSource read_standard_input(const std::string& shown_path) {
    LoadedSource read = read_source(std::cin, shown_path);
    bool nothing = read.problems.empty() && read.file->text().empty();
    return nothing ? refused(shown_path, "standard input is empty or closed") : read;
}

} // namespace

LoadedSource load_source(const std::filesystem::path& path) {
    if (const std::string* text = text_in_memory(path))
        return check_source(path.string(), *text);
    if (auto why = why_not_a_file(path); !why.empty())
        return refused(path.string(), why);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return refused(path.string(), "the file cannot be opened for reading");
    return read_source(in, path.string());
}

LoadedSource load_input(const std::filesystem::path& path) {
    if (!is_standard_stream(path))
        return load_source(path);
    static const LoadedSource standard_input = read_standard_input(shown_input(path));
    return standard_input;
}

LoadedSource load_shown_input(const std::string& shown_path) {
    return load_input(shown_path == shown_input("-") ? "-" : shown_path);
}

} // namespace placedpar
