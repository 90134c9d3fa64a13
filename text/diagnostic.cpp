#include "text/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

constexpr std::size_t widest_excerpt = 160;

/// The line without the bytes that a terminal would act on.
std::string printable(std::string_view line) {
    std::string result(line);
    for (auto& c : result)
        if (c != '\t' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7f))
            c = '?';
    return result;
}

/// A byte that continues a UTF-8 character takes no column of its own on the screen.
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::string caret_line(std::string_view before) {
    std::string result;
    for (char c : before)
        if (!continues_character(c))
            result += c == '\t' ? '\t' : ' ';
    return result + "^\n";
}

/// Where the part of a long line begins that is shown, so that the caret is about in its middle.
std::size_t excerpt_start(std::string_view line, std::size_t caret) {
    if (line.size() <= widest_excerpt || caret <= widest_excerpt / 2)
        return 0;
    auto start = std::min(caret - widest_excerpt / 2, line.size() - widest_excerpt / 2);
    while (start < caret && continues_character(line[start]))
        ++start;
    return start;
}

std::string excerpt(const Location& location) {
    if (!location.file || location.line == 0)
        return "";
    auto line = printable(location.file->line(location.line));
    auto caret = std::min(location.column == 0 ? 0 : location.column - 1, line.size());
    auto start = excerpt_start(line, caret);
    auto shown = line.substr(start, widest_excerpt);
    std::string lead = start > 0 ? "..." : "";
    std::string tail = start + shown.size() < line.size() ? "..." : "";
    return fmt::format("    {}{}{}\n    {}{}", lead, shown, tail, std::string(lead.size(), ' '),
                       caret_line(std::string_view(shown).substr(0, caret - start)));
}

std::string heading(const Location& location) {
    auto where = location.text();
    return where.empty() ? "" : where + ": ";
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

std::string render(const Diagnostic& diagnostic) {
    auto word = diagnostic.severity == Severity::error ? "error" : "warning";
    auto text = fmt::format("{}{}: {}\n{}", heading(diagnostic.location), word, diagnostic.message,
                            excerpt(diagnostic.location));
    if (!diagnostic.hint.empty())
        text += "hint: " + diagnostic.hint + "\n";
    for (const auto& other : diagnostic.others)
        text += fmt::format("{}note: {}\n{}", heading(other.location), other.message, excerpt(other.location));
    return text;
}

std::string render(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const auto& diagnostic : diagnostics)
        text += render(diagnostic);
    return text;
}

} // namespace placedpar
