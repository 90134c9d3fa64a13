#include "occam/language/lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace placedpar::occam {

Lines::Lines(Reading& reading, std::uint32_t file) : reading_(reading), scanner_(reading.program, reading.reporter) {
    files_.push_back({.index = file, .rest = reading.program.files[file]->text()});
    last_ = {file, 1, 1};
}

std::optional<Lines::TextLine> Lines::take_text() {
    while (files_.back().rest.empty()) {
        close_file();
        if (files_.size() == 1)
            return std::nullopt;
        files_.pop_back();
        reading_.open.pop_back();
    }
    File& file = files_.back();
    const auto end = std::min(file.rest.find('\n'), file.rest.size());
    std::string_view text = file.rest.substr(0, end);
    file.rest.remove_prefix(std::min(end + 1, file.rest.size()));
    if (text.ends_with('\r'))
        text.remove_suffix(1);
    constexpr char end_of_file_in_dos = '\x1a';
    if (const auto found = text.find(end_of_file_in_dos); found != std::string_view::npos) {
        text = text.substr(0, found);
        file.rest = {};
    }
    last_ = {file.index, ++file.line, 1};
    return TextLine{text, last_, file.indentation};
}

void Lines::close_file() {
    for (const Condition& condition : files_.back().conditions)
        reading_.reporter.error(reading_.location(condition.at), "this #IF has no #ENDIF in its file");
    files_.back().conditions.clear();
}

bool Lines::is_left_out() const { return !std::ranges::all_of(files_.back().conditions, &Condition::is_true); }

/// Returns the next line that is not skipped. Executes directives; if the parser must see a directive, appends it to
/// `words`.
std::optional<Lines::TextLine> Lines::next_text(std::vector<Word>& words) {
    if (held_) {
        last_ = held_->start;
        return std::exchange(held_, std::nullopt);
    }
    while (auto line = take_text()) {
        const std::string_view name = directive_of(line->text);
        if (is_condition(name))
            execute_condition(name, *line);
        else if (is_left_out())
            continue;
        else if (name.empty())
            return line;
        else if (execute(name, *line, words); !words.empty())
            return line;
    }
    return std::nullopt;
}

Line Lines::next() {
    Line line;
    while (line.words.empty()) {
        const auto text = next_text(line.words);
        if (!text) {
            line.is_end = true;
            line.words.push_back({.kind = WordKind::end, .at = last_});
            return line;
        }
        if (line.words.empty()) {
            const bool in_string = scanner_.scan(text->text, text->start, text->indentation, line.words);
            warn_of_tabs(*text);
            continue_line(line, in_string);
        }
    }
    const Word& last = line.words.back();
    Place behind = last.at;
    if (last.at.file == last_.file && last.at.line == last_.line)
        behind.column += static_cast<std::uint32_t>(last.text.size());
    line.words.push_back({.kind = WordKind::end, .at = behind});
    return line;
}

/// Appends the continuation lines of `line`. A line that is indented less than `line` is not a continuation.
void Lines::continue_line(Line& line, bool in_string) {
    while (in_string || (!line.words.empty() && continues_line(line.words.back()))) {
        std::vector<Word> directive, words;
        const Place last = last_;
        const auto text = next_text(directive);
        if (!directive.empty())
            reading_.reporter.error(reading_.location(directive.front().at),
                                    "a directive cannot be in the middle of a statement");
        else if (in_string && text) {
            in_string = scanner_.continue_string(text->text, text->start, text->indentation, line.words);
            continue;
        }
        if (!text) {
            if (in_string)
                reading_.reporter.error(reading_.location(line.words.back().at), "the string is not closed");
            return;
        }
        in_string = directive.empty() && scanner_.scan(text->text, text->start, text->indentation, words);
        if (!words.empty() && words.front().indentation < line.words.front().indentation) {
            held_ = text;
            last_ = last;
            return;
        }
        line.words.insert(line.words.end(), std::make_move_iterator(words.begin()),
                          std::make_move_iterator(words.end()));
    }
}

void Lines::warn_of_tabs(const TextLine& line) {
    const auto indentation = line.text.substr(0, std::min(line.text.find_first_not_of(" \t"), line.text.size()));
    const auto tab = indentation.find('\t');
    if (tab == std::string_view::npos || std::exchange(warned_of_tabs_, true))
        return;
    Place at = line.start;
    at.column += static_cast<std::uint32_t>(tab);
    reading_.reporter.warning(reading_.location(at),
                              "a tab in an indentation counts as blanks up to the next multiple of 8 columns",
                              "indent with blanks: two for each level");
}

/// Returns the word after the directive. If there is no word of this kind, reports an error and returns null.
const Word* Lines::argument(const std::vector<Word>& words, WordKind kind, std::string_view what) {
    if (words.size() >= 2 && words[1].kind == kind)
        return &words[1];
    if (words.size() < 2 || words[1].kind != WordKind::illegal)
        reading_.reporter.error(reading_.location(words.front().at),
                                fmt::format("{} is missing after {}", what, words.front().text));
    return nullptr;
}

void Lines::execute(std::string_view name, const TextLine& line, std::vector<Word>& words) {
    const auto start = static_cast<std::size_t>(name.data() - line.text.data());
    Place at = line.start;
    at.column += static_cast<std::uint32_t>(start);
    if (name == "#COMMENT")
        return;
    const bool is_read = name == "#INCLUDE" || name == "#USE" || name == "#OPTION" || name == "#PRAGMA" ||
                         name == "#DEFINE" || name == "#UNDEF";
    if (!is_read)
        return execute_message(reading_, name, line.text.substr(start + name.size()), at);
    std::vector<Word> own;
    scanner_.scan(line.text, line.start, line.indentation, own);
    if (name == "#INCLUDE")
        execute_include(own);
    else if (name == "#OPTION") {
        if (const Word* letters = argument(own, WordKind::string, "a string of letters"))
            execute_option(reading_, *letters);
    } else if (name == "#PRAGMA") {
        if (const Word* what = argument(own, WordKind::name, "a name"))
            execute_pragma(reading_, *what);
    } else if (name == "#USE") {
        if (argument(own, WordKind::string, "the name of a file"))
            words = std::move(own);
    } else
        execute_define(own, name == "#DEFINE");
}

void Lines::execute_include(const std::vector<Word>& words) {
    const Word* name = argument(words, WordKind::string, "the name of a file");
    if (!name)
        return;
    auto found = find_file(reading_, name->bytes, FileUse::include, name->at);
    if (!found || !found->file)
        return;
    const Location here = reading_.location(words.front().at);
    const auto index = add_file(reading_, found->file, here);
    reading_.open.push_back({std::move(found->key), here});
    files_.push_back(
        {.index = index, .rest = reading_.program.files[index]->text(), .indentation = words.front().indentation});
}

void Lines::execute_define(const std::vector<Word>& words, bool is_defined) {
    const Word* name = argument(words, WordKind::name, "a name");
    if (!name)
        return;
    const std::string key(name->text);
    if (!is_defined)
        reading_.defined.erase(key);
    else
        reading_.defined[key] = words.size() < 3                    ? std::string()
                                : words[2].kind == WordKind::string ? words[2].bytes
                                                                    : std::string(words[2].text);
}

void Lines::execute_condition(std::string_view name, const TextLine& line) {
    std::vector<Word> words;
    auto& conditions = files_.back().conditions;
    const bool outer_is_read =
        conditions.empty() || std::all_of(conditions.begin(), conditions.end() - (name == "#IF" ? 0 : 1),
                                          [](const Condition& each) { return each.is_true; });
    if (outer_is_read)
        scanner_.scan(line.text, line.start, line.indentation, words);
    else
        words.push_back({.kind = WordKind::directive, .text = name, .at = line.start});
    if (name == "#IF")
        conditions.push_back({.at = words.front().at, .is_true = outer_is_read && evaluate_condition(reading_, words)});
    else if (conditions.empty())
        reading_.reporter.error(reading_.location(words.front().at), fmt::format("{} has no #IF above it", name));
    else if (name == "#ENDIF")
        conditions.pop_back();
    else
        execute_else(words, name == "#ELSE");
    if (name == "#IF")
        conditions.back().was_true = conditions.back().is_true || !outer_is_read;
}

/// Executes #ELSE or #ELIF.
void Lines::execute_else(const std::vector<Word>& words, bool is_else) {
    Condition& condition = files_.back().conditions.back();
    if (condition.has_else)
        reading_.reporter.error(reading_.location(words.front().at),
                                fmt::format("{} follows the #ELSE of its #IF", words.front().text), "",
                                {{"the #IF is here", reading_.location(condition.at)}});
    condition.has_else |= is_else;
    condition.is_true = !condition.was_true && (is_else || evaluate_condition(reading_, words));
    condition.was_true |= condition.is_true;
}

} // namespace placedpar::occam
