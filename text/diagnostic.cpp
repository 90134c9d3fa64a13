#include "text/diagnostic.hpp"

#include "text/paint.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

constexpr std::size_t widest_excerpt = 160;

/// Returns whether a byte continues a UTF-8 character.
bool within_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Returns the line with the caret: a blank for each character of `before`, with tabs kept, then the caret.
std::string caret_line(std::string_view before) {
    std::string result;
    for (char c : before)
        if (!within_character(c))
            result += c == '\t' ? '\t' : ' ';
    return result + painted(Paint::caret, "^") + "\n";
}

/// Returns the start of the excerpt of a long line, chosen so that the caret is near the middle of the excerpt.
std::size_t excerpt_start(std::string_view line, std::size_t caret) {
    if (line.size() <= widest_excerpt || caret <= widest_excerpt / 2)
        return 0;
    auto start = std::min(caret - widest_excerpt / 2, line.size() - widest_excerpt / 2);
    while (start < caret && within_character(line[start]))
        ++start;
    return start;
}

std::size_t excerpt_end(std::string_view line, std::size_t start) {
    auto end = std::min(start + widest_excerpt, line.size());
    while (end < line.size() && within_character(line[end]))
        ++end;
    return end;
}

std::string excerpt(const Location& location) {
    if (!location.file || location.line == 0)
        return "";
    auto line = location.file->line(location.line);
    auto caret = std::min(location.column == 0 ? 0 : location.column - 1, line.size());
    auto start = excerpt_start(line, caret), end = excerpt_end(line, start);
    auto before = escaped(line.substr(start, caret - start));
    std::string lead = start > 0 ? "..." : "";
    std::string tail = end < line.size() ? "..." : "";
    return fmt::format("    {}{}{}{}\n    {}{}", lead, before, escaped(line.substr(caret, end - caret)), tail,
                       std::string(lead.size(), ' '), caret_line(before));
}

std::string heading(const Location& location) {
    auto where = location.text();
    return where.empty() ? "" : painted(Paint::place, escaped(where) + ":") + " ";
}

} // namespace

Diagnostic error_at(std::size_t line, std::size_t column, std::string message, std::string hint) {
    return {Severity::error, std::move(message), {nullptr, line, column}, std::move(hint), {}};
}

Diagnostic warning_at(std::size_t line, std::size_t column, std::string message, std::string hint) {
    return {Severity::warning, std::move(message), {nullptr, line, column}, std::move(hint), {}};
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
    return std::ranges::any_of(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string render(const SecondPlace& other) {
    return fmt::format("{}{} {}\n{}", heading(other.location), painted(Paint::note, "note:"), escaped(other.message),
                       excerpt(other.location));
}

std::string render(const Diagnostic& diagnostic) {
    auto word =
        diagnostic.severity == Severity::error ? painted(Paint::error, "error:") : painted(Paint::warning, "warning:");
    auto text = fmt::format("{}{} {}\n{}", heading(diagnostic.location), word, escaped(diagnostic.message),
                            excerpt(diagnostic.location));
    if (!diagnostic.hint.empty())
        text += painted(Paint::note, "hint:") + " " + escaped(diagnostic.hint) + "\n";
    for (const auto& other : diagnostic.others)
        text += render(other);
    return text;
}

std::string render(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const auto& diagnostic : diagnostics)
        text += render(diagnostic);
    return text;
}

std::string not_shown(std::size_t count, Severity severity) {
    auto word = severity == Severity::error ? "error" : "warning";
    return count == 0 ? "" : fmt::format("... {} more {}{} not shown\n", count, word, count == 1 ? "" : "s");
}

} // namespace placedpar
