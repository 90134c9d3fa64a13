#include "occam/language/blanks.hpp"

#include "occam/language/words.hpp"

#include <string_view>
#include <vector>

namespace placedpar::occam {

namespace {

/// Returns the words of a program, each as its indentation followed by its text.
std::vector<std::string> occam_words(const std::shared_ptr<const SourceFile>& file) {
    Program program;
    program.files.push_back(file);
    Reporter ignored;
    WordScanner scanner(program, ignored);
    std::vector<Word> words;
    std::vector<std::string> texts;
    bool in_string = false;
    std::string_view rest = file->text();
    for (std::uint32_t line = 1; !rest.empty(); ++line) {
        const auto end = std::min(rest.find('\n'), rest.size());
        if (!in_string) // otherwise continue_string() appends to the last word of the previous line
            words.clear();
        const auto scan = in_string ? &WordScanner::continue_string : &WordScanner::scan;
        in_string = (scanner.*scan)(file->line(line), {0, line, 1}, 0, words);
        for (const Word& word : words)
            texts.push_back(std::to_string(word.indentation) + " " + std::string(word.text) + word.bytes);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return texts;
}

/// Returns the line without blanks at its end. Each leading tab is replaced by blanks up to the next multiple of eight
/// columns.
std::string laid_out_line(std::string_view line) {
    constexpr std::size_t tab = 8;
    const auto last = line.find_last_not_of(" \t\r\f\v");
    line = line.substr(0, last == line.npos ? 0 : last + 1);
    const auto first = std::min(line.find_first_not_of(" \t"), line.size());
    std::size_t blanks = 0;
    for (const char c : line.substr(0, first))
        blanks = c == '\t' ? (blanks / tab + 1) * tab : blanks + 1;
    return std::string(blanks, ' ') + std::string(line.substr(first));
}

} // namespace

std::optional<std::string> with_tidy_blanks(const std::shared_ptr<const SourceFile>& file) {
    std::string text;
    std::string_view rest = file->text();
    while (!rest.empty()) {
        const auto end = std::min(rest.find('\n'), rest.size());
        text += laid_out_line(rest.substr(0, end)) + "\n";
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    try {
        const auto made = std::make_shared<const SourceFile>(file->path(), text);
        return occam_words(made) == occam_words(file) ? std::optional(text) : std::nullopt;
    } catch (const GiveUp&) { // the text has too many errors
        return std::nullopt;
    }
}

} // namespace placedpar::occam
