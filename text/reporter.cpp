#include "text/reporter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace placedpar {

namespace {

/// The greatest number of "included here" notes on one diagnostic. The first note is for the innermost file.
constexpr int most_included_notes = 10;

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Returns the words of a line, without repetitions.
std::set<std::string_view> words_in(std::string_view line) {
    std::set<std::string_view> words;
    for (auto begin = line.begin(); begin != line.end();) {
        begin = std::find_if(begin, line.end(), in_word);
        auto end = std::find_if_not(begin, line.end(), in_word);
        words.insert(
            line.substr(static_cast<std::size_t>(begin - line.begin()), static_cast<std::size_t>(end - begin)));
        begin = end;
    }
    return words;
}

} // namespace

void Reporter::error(const Location& location, std::string message, std::string hint, std::vector<SecondPlace> others) {
    if (!is_first_at(location)) {
        if (++repeated_ >= most_repeated)
            throw GiveUp{};
        return;
    }
    if (++errors_ <= most_errors)
        keep({Severity::error, std::move(message), location, std::move(hint), std::move(others)});
    if (errors_ >= most_counted_errors)
        throw GiveUp{};
}

void Reporter::give_up(const Location& location, std::string message, std::vector<SecondPlace> others) {
    error(location, std::move(message), "", std::move(others));
    throw GiveUp{};
}

void Reporter::warning(const Location& location, std::string message, std::string hint) {
    if (++warnings_ <= most_warnings)
        keep({Severity::warning, std::move(message), location, std::move(hint), {}});
}

void Reporter::note_options(Diagnostic& diagnostic) const {
    const Location& at = diagnostic.location;
    if (options_.empty() || !at.file)
        return;
    for (std::string_view word : words_in(at.file->line(at.line)))
        if (auto option = options_.find(word); option != options_.end() && option->second.file != at.file)
            diagnostic.others.push_back({fmt::format("\"{}\" is set here", word), option->second});
}

void Reporter::keep(Diagnostic diagnostic) {
    note_options(diagnostic);
    auto file = included_.find(diagnostic.location.file);
    for (int notes = 0; file != included_.end() && notes < most_included_notes; ++notes) {
        if (std::ranges::find(diagnostic.others, file->second, &SecondPlace::location) == diagnostic.others.end())
            diagnostic.others.push_back({"included here", file->second});
        file = included_.find(file->second.file);
    }
    diagnostics_.push_back(std::move(diagnostic));
}

void Reporter::replace_all(const Location& location, std::string message, std::string hint) {
    diagnostics_.clear();
    errors_ = 1;
    warnings_ = 0;
    keep({Severity::error, std::move(message), location, std::move(hint), {}});
}

std::shared_ptr<const SourceFile> Reporter::first_file() const {
    auto first = std::ranges::find(diagnostics_, Severity::error, &Diagnostic::severity);
    return first == diagnostics_.end() ? nullptr : first->location.file;
}

std::string Reporter::not_shown() const {
    return placedpar::not_shown(errors_ - std::min(errors_, most_errors), Severity::error) +
           placedpar::not_shown(warnings_ - std::min(warnings_, most_warnings), Severity::warning);
}

bool Reporter::is_first_at(const Location& place) {
    return !place.file || places_.emplace(place.file, place.line, place.column).second;
}

} // namespace placedpar
