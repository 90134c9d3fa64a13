#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::editor {

/// Holds a word of a study: a part of a key, or a value without its quotes. Dots separate the parts of a key, so a
/// value of `master.trials` below [set] has the path {"set", "master", "trials"}.
struct StudyWord {
    std::vector<std::string> path = {}; ///< keys of the tables around the word, then the parts of its key before it
    std::string text = {};
    std::size_t first = 0, end = 0; ///< offsets of the text
    bool is_key = false;
};

/// Holds the words of a study. The text need not be valid TOML: a line that begins with a table's name in brackets, or
/// with `key =` in a list, ends all that is open before it.
struct StudyText {
    std::vector<StudyWord> words = {};
    StudyWord last = {}; ///< the word at the end of the text, without a closing quote; empty if there is none
    bool in_comment = false, in_quotes = false, in_header = false; ///< what the end of the text is in
};

StudyText read_study_text(std::string_view);

} // namespace placedpar::editor
