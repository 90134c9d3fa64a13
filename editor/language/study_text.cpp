#include "editor/language/study_text.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace placedpar::editor {

namespace {

using Path = std::vector<std::string>;

bool is_in_word(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) != 0 || byte >= 0x80 || c == '_' || c == '-' || c == '+';
}

class StudyScanner {
public:
    explicit StudyScanner(std::string_view text) : text_(text) {}

    StudyText scan() {
        while (at_ < text_.size() && !found_.in_comment && !found_.in_quotes)
            step(text_[at_]);
        if (!is_open_word_)
            found_.last = {path_here(), "", text_.size(), text_.size(), in_key_};
        return std::move(found_);
    }

private:
    /// A table or a list that is open.
    struct Frame {
        bool is_table = false;
        Path path;
    };

    void step(char c) {
        is_open_word_ = false;
        if (c == '#')
            skip_comment();
        else if (c == '\n')
            end_line();
        else if (c == '"' || c == '\'')
            take_quoted(c);
        else if (is_in_word(c))
            take_word();
        else
            take_symbol(c);
    }

    void skip_comment() {
        const std::size_t end = text_.find('\n', at_);
        found_.in_comment = end == text_.npos;
        at_ = std::min(end, text_.size());
    }

    /// Goes on to the next line. This ends the statement, if no list is open. A table in braces must end in the line in
    /// which it begins.
    void end_line() {
        ++at_;
        while (!open_.empty() && open_.back().is_table)
            close();
        if (open_.empty())
            begin_statement();
    }

    void begin_statement() {
        open_.clear();
        keys_.clear();
        in_key_ = true;
        found_.in_header = false;
    }

    void take_symbol(char c) {
        const bool at_start = is_line_start();
        ++at_;
        if (c == '[' && (open_.empty() ? in_key_ && keys_.empty() : at_start && is_header()))
            begin_header();
        else if (c == '[' || c == '{')
            open(c == '{');
        else if ((c == ']' || c == '}') && !open_.empty())
            close();
        else if (c == '=' && !found_.in_header)
            in_key_ = false;
        else if (c == ',' && !open_.empty() && open_.back().is_table)
            begin_member();
        else if (c == ']' && found_.in_header)
            end_header();
    }

    void begin_header() {
        begin_statement();
        header_.clear();
        at_ += at_ < text_.size() && text_[at_] == '[' ? 1 : 0;
        found_.in_header = true;
    }

    void end_header() {
        found_.in_header = false;
        header_ = std::exchange(keys_, {});
        in_key_ = false; // nothing can follow in this line
    }

    void open(bool is_table) {
        open_.push_back({is_table, path_here()});
        keys_.clear();
        in_key_ = is_table;
    }

    void begin_member() {
        keys_.clear();
        in_key_ = true;
    }

    /// Ends the innermost table or list, which is the value of a key, or a member of a list.
    void close() {
        const Path path = std::move(open_.back().path);
        open_.pop_back();
        keys_.assign(path.begin() + static_cast<std::ptrdiff_t>(base().size()), path.end());
        in_key_ = false;
    }

    /// Returns whether the rest of the line is the name of a table and its brackets.
    bool is_header() const {
        const std::string_view line = text_.substr(at_, text_.find('\n', at_) - at_);
        const std::size_t name = line.find_first_not_of('[');
        return name != line.npos && std::isalpha(static_cast<unsigned char>(line[name])) != 0 &&
               line.find(']') != line.npos;
    }

    bool is_line_start() const {
        const std::size_t start = at_ == 0 ? 0 : text_.rfind('\n', at_ - 1) + 1;
        return text_.find_first_not_of(" \t", start) == at_;
    }

    void take_word() {
        const std::size_t first = at_;
        // A value may contain dots, as a number does.
        while (at_ < text_.size() && (is_in_word(text_[at_]) || (!in_key_ && text_[at_] == '.')))
            ++at_;
        if (!in_key_ && !open_.empty() && begins_statement(first))
            begin_statement();
        add(first, at_);
    }

    /// Returns whether the word that begins here is at the beginning of its line, and `=` follows.
    bool begins_statement(std::size_t first) const {
        const std::size_t start = first == 0 ? 0 : text_.rfind('\n', first - 1) + 1;
        const std::size_t next = text_.find_first_not_of(" \t", at_);
        return text_.find_first_not_of(" \t", start) == first && next != text_.npos && text_[next] == '=';
    }

    void take_quoted(char quote) {
        const std::string three(3, quote);
        const bool is_long = text_.substr(at_).starts_with(three);
        const std::size_t first = at_ + (is_long ? 3 : 1);
        std::size_t end = first;
        const auto is_end = [&] {
            return is_long ? text_.substr(end).starts_with(three) : text_[end] == quote || text_[end] == '\n';
        };
        for (; end < text_.size() && !is_end(); ++end)
            end += text_[end] == '\\' && quote == '"' && end + 1 < text_.size() ? 1 : 0;
        found_.in_quotes = end == text_.size();
        add(first, end);
        at_ = std::min(text_.size(), end + (is_long ? 3 : found_.in_quotes || text_[end] == '\n' ? 0 : 1));
    }

    void add(std::size_t first, std::size_t end) {
        StudyWord word{path_here(), std::string(text_.substr(first, end - first)), first, end, in_key_};
        if (in_key_)
            keys_.push_back(word.text);
        is_open_word_ = end == text_.size();
        if (is_open_word_)
            found_.last = word;
        found_.words.push_back(std::move(word));
    }

    const Path& base() const { return open_.empty() ? header_ : open_.back().path; }

    Path path_here() const {
        Path path = base();
        path.insert(path.end(), keys_.begin(), keys_.end());
        return path;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    StudyText found_;
    Path header_; ///< name of the table in brackets
    Path keys_;   ///< parts of the present key
    std::vector<Frame> open_;
    bool in_key_ = true;
    bool is_open_word_ = false;
};

} // namespace

StudyText read_study_text(std::string_view text) { return StudyScanner(text).scan(); }

} // namespace placedpar::editor
