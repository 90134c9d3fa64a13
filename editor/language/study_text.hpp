#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::editor {

/// Holds a word of a study, which is a file in TOML about experiments with a netlist. A word is a part of a key, or a
/// value without its quotes. Dots separate the parts of a key: a value of `master.trials` below [set] has the path
/// {"set", "master", "trials"}.
struct StudyWord {
    std::vector<std::string> path =
        {}; ///< keys of the tables that contain the word, then the parts of its own key that precede it
    std::string text = {};
    std::size_t first = 0, end = 0; ///< offsets of the word's beginning and end in the study
    bool is_key = false;
};

/// Holds the words of a study, for an editor. The text need not be valid TOML, since users leave things unfinished
/// while they type. A table's name in brackets at the beginning of a line ends all lists that are open before it. A
/// `key =` at the beginning of a line within a list does so, too.
struct StudyText {
    std::vector<StudyWord> words = {};
    StudyWord last = {}; ///< the unfinished word at the end of the text; empty if there is none
    bool in_comment = false, in_quotes = false,
         in_header = false; ///< whether the end of the text is in a comment, a string, or a table's name in brackets
};

StudyText read_study_text(std::string_view);

} // namespace placedpar::editor
