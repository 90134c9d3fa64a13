#include "text/diagnostic.hpp"

#include "text/paint.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t widest_excerpt = 160;

/// Returns whether a byte continues a UTF-8 character.
bool within_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Returns `before`, the text left of the caret, with every character replaced by a blank.
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

/// Returns the message with "#" for each number. Digits within a name such as "P1" stay.
std::string without_numbers(std::string_view message) {
    auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    std::string kind;
    for (std::size_t i = 0; i < message.size(); ++i) {
        const bool number =
            is_digit(message[i]) && (i == 0 || !(is_letter(message[i - 1]) || is_digit(message[i - 1])));
        kind += number ? '#' : message[i];
        if (number)
            i = std::min(message.find_first_not_of("0123456789.e+-", i), message.size()) - 1;
    }
    return kind;
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

std::vector<Diagnostic> RepeatedFaults::take(std::vector<Diagnostic> faults) {
    std::vector<Diagnostic> firsts;
    std::vector<std::string> kinds; // of the firsts
    for (Diagnostic& fault : faults) {
        std::string kind = without_numbers(fault.message);
        const auto [found, is_new] = kinds_.try_emplace(kind, Kind{fault.message, fault.location.line});
        if (is_new || fault.location.line == found->second.line) {
            firsts.push_back(std::move(fault));
            kinds.push_back(is_new ? std::move(kind) : "");
        } else {
            ++found->second.more;
            found->second.last = fault.location.line;
        }
    }
    for (std::size_t i = 0; i < firsts.size(); ++i)
        if (const auto found = kinds_.find(kinds[i]); found != kinds_.end() && found->second.more > 0) {
            const std::size_t more = std::exchange(found->second.more, 0);
            firsts[i].message +=
                more == 1 ? fmt::format(" (and line {})", found->second.last)
                          : fmt::format(" (and {} more lines, the last is line {})", more, found->second.last);
        }
    return firsts;
}

std::string RepeatedFaults::later() const {
    std::string text;
    for (const auto& [kind, each] : kinds_)
        if (each.more > 0)
            text += fmt::format("... {} more like \"{}\", the last in line {}\n", each.more, each.message, each.last);
    return text;
}

std::string not_shown(std::size_t count, Severity severity) {
    auto word = severity == Severity::error ? "error" : "warning";
    return count == 0 ? "" : fmt::format("... {} more {}{} not shown\n", count, word, count == 1 ? "" : "s");
}

} // namespace placedpar
