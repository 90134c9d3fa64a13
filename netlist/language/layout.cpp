#include "netlist/language/layout.hpp"

#include "netlist/language/names_in_text.hpp"
#include "text/positions.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t step = 4; ///< blanks of indentation

bool is_one_of(const Token& token, std::string_view symbols) {
    return token.kind == TokenKind::symbol && token.text.size() == 1 && symbols.find(token.text) != symbols.npos;
}

/// Returns whether a token is an operator with one operand, such as a sign. No blank is written after it.
bool is_unary(const std::vector<Token>& tokens, std::size_t index) {
    if (!is_one_of(tokens[index], "-+!~") || index < 2)
        return false;
    const Token& before = tokens[index - 1];
    const bool begins_value = tokens[index - 2].is_word("val");
    return begins_value || (before.kind == TokenKind::symbol && !is_one_of(before, ")]"));
}

/// Returns the blanks between two words of a line. Before a parenthesis that follows a name, and at braces, the result
/// has a blank only if the text has blanks there. Two minus signs stay apart, because `--` begins a comment in occam,
/// which the lexer refuses.
std::string gap(const std::vector<Token>& tokens, std::size_t index, std::string_view written) {
    const Token &before = tokens[index - 1], &token = tokens[index];
    const bool either =
        (token.is("(") && (before.kind == TokenKind::name || before.is("]"))) || before.is("{") || token.is("}");
    if (either)
        return written.empty() ? "" : " ";
    if (before.is("-") && token.is("-"))
        return " ";
    const bool is_subscript = token.is("[") && (before.kind == TokenKind::name || before.is("]") || before.is(")"));
    if (is_subscript || is_one_of(token, ",;)].") || is_one_of(before, "([.") || is_unary(tokens, index - 1))
        return "";
    return " ";
}

using LineAndColumn = std::pair<std::size_t, std::size_t>;

/// Finds how deep statements are nested in blocks and in the bodies of `rep` and `if`.
class Depths {
public:
    Depths(const NetlistSyntax& syntax) : file_(syntax.file.get()) { walk(syntax.statements, 0); }

    /// Returns the depth of the statement that begins at a place; nothing if no statement begins there.
    std::optional<std::size_t> at(const Location& at) const {
        const auto found = depths_.find({at.line, at.column});
        return found == depths_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    void walk(const Statements& statements, std::size_t depth) {
        for (const Statement& each : statements)
            walk(each, depth);
    }

    void walk(const Statement& statement, std::size_t depth) {
        if (statement.at.file.get() == file_)
            depths_[{statement.at.line, statement.at.column}] = depth;
        if (const auto* block = std::get_if<BlockStatement>(&statement.form))
            return walk(block->statements, depth + 1);
        if (const auto* rep = std::get_if<RepStatement>(&statement.form))
            return body(*rep->body, depth);
        const auto* choice = std::get_if<IfStatement>(&statement.form);
        if (!choice)
            return;
        body(*choice->then, depth);
        if (choice->otherwise)
            body(*choice->otherwise, depth);
    }

    void body(const Statement& statement, std::size_t depth) {
        walk(statement, std::holds_alternative<BlockStatement>(statement.form) ? depth : depth + 1);
    }

    const SourceFile* file_;
    std::map<LineAndColumn, std::size_t> depths_;
};

class NetlistLayout {
public:
    explicit NetlistLayout(const NetlistSyntax& syntax)
        : file_(*syntax.file), tokens_(syntax.tokens), depths_(syntax) {}

    std::string written() {
        for (std::size_t i = 0; i < tokens_.size(); ++i)
            add(i);
        end_line();
        while (!lines_.empty() && lines_.back().empty())
            lines_.pop_back();
        std::string text;
        for (const std::string& line : lines_)
            text += line + "\n";
        return text;
    }

private:
    struct Bracket {
        std::size_t indentation = 0; ///< indentation of the lines within the block
        bool is_block = false;
        std::size_t depth = 0; ///< depth of the block
    };

    std::string_view between(std::size_t from, std::size_t until) const {
        return std::string_view(file_.text()).substr(from, until - from);
    }

    /// Adds a word, with the comments and the breaks in front of it.
    void add(std::size_t i) {
        const Token& token = tokens_[i];
        const std::size_t from = i == 0 ? 0 : offset_of(tokens_[i - 1].end);
        const bool is_end = token.kind == TokenKind::end;
        const std::size_t until = is_end ? file_.text().size() : offset_of(token.at);
        if (const auto depth = depth_at(i))
            depth_ = *depth;
        add_gap(i, between(from, until));
        if (is_end)
            return;
        if (line_.empty())
            line_ = std::string(indentation(i), ' ');
        if (is_one_of(token, ")]}") && !brackets_.empty())
            brackets_.pop_back();
        line_ += between(until, offset_of(token.end));
        open_bracket(i);
    }

    /// Returns the depth of the statement that begins with this word. The syntax tree has for a `val` statement the
    /// place of its name.
    std::optional<std::size_t> depth_at(std::size_t i) const {
        const Token& token = tokens_[i];
        if (token.is_word("val") && i + 1 < tokens_.size())
            return depths_.at(tokens_[i + 1].at);
        if (token.is("}") && !brackets_.empty() && brackets_.back().is_block)
            return brackets_.back().depth;
        if (!token.is_word("else") || i + 1 == tokens_.size())
            return depths_.at(token.at);
        const auto body = depths_.at(tokens_[i + 1].at); // the block after an `else` has the depth of the `else`
        return body && !tokens_[i + 1].is("{") ? std::optional(*body - 1) : body;
    }

    std::size_t indentation(std::size_t i) const {
        if (!brackets_.empty() && !brackets_.back().is_block)
            return brackets_.back().indentation;
        if (tokens_[i].kind == TokenKind::directive || tokens_[i].kind == TokenKind::end)
            return brackets_.empty() ? 0 : brackets_.back().indentation;
        return depth_at(i) ? depth_ * step : (depth_ + 1) * step;
    }

    void open_bracket(std::size_t i) {
        const Token& token = tokens_[i];
        const auto block = token.is("{") ? depths_.at(token.at) : std::nullopt;
        if (block)
            brackets_.push_back({(*block + 1) * step, true, *block});
        else if (is_one_of(token, "([{"))
            brackets_.push_back({line_.size(), false, 0});
    }

    /// Adds what is between two words: blanks, comments and ends of lines.
    void add_gap(std::size_t i, std::string_view rest) {
        if (rest.find_first_of("\n/") == rest.npos && !line_.empty() && tokens_[i].kind != TokenKind::end)
            line_ += gap(tokens_, i, rest);
        while (rest.find_first_of("\n/") != rest.npos) {
            const auto blanks = rest.find_first_of("\n/");
            const std::string_view space = rest.substr(0, blanks);
            rest.remove_prefix(blanks);
            if (rest.front() == '\n') {
                end_line();
                rest.remove_prefix(1);
                continue;
            }
            const auto length = std::min(rest.find("*/", 2), rest.size() - 2) + 2;
            add_comment(i, space, rest.substr(0, length));
            rest.remove_prefix(length);
            if (rest.find_first_of("\n/") == rest.npos && !rest.empty())
                line_ += " ";
        }
    }

    /// Adds a comment unchanged. The blanks before it stay, since comments are often aligned.
    void add_comment(std::size_t i, std::string_view space, std::string_view comment) {
        if (line_.empty())
            line_ = std::string(indentation_of_comment(i), ' ');
        else
            line_ += space;
        for (auto end = comment.find('\n'); end != comment.npos; end = comment.find('\n')) {
            lines_.push_back(line_ + std::string(comment.substr(0, end)));
            line_.clear();
            comment.remove_prefix(end + 1);
        }
        line_ += comment;
    }

    std::size_t indentation_of_comment(std::size_t next) const {
        const bool ends_block = tokens_[next].is("}") && !brackets_.empty() && brackets_.back().is_block;
        return ends_block ? brackets_.back().indentation : indentation(next);
    }

    void end_line() {
        const auto last = line_.find_last_not_of(" \t\r\f\v");
        line_.resize(last == line_.npos ? 0 : last + 1);
        if (!line_.empty() || (!lines_.empty() && !lines_.back().empty()))
            lines_.push_back(line_);
        line_.clear();
    }

    const SourceFile& file_;
    const std::vector<Token>& tokens_;
    Depths depths_;
    std::vector<std::string> lines_;
    std::string line_;
    std::vector<Bracket> brackets_;
    std::size_t depth_ = 0; ///< depth of the statement that began last
};

} // namespace

std::optional<std::string> laid_out_netlist(const std::shared_ptr<const SourceFile>& file) {
    const NetlistSyntax syntax = read_syntax(file);
    const bool is_refused = std::ranges::any_of(syntax.diagnostics, [&](const Diagnostic& each) {
        return each.severity == Severity::error && each.location.file == file;
    });
    return is_refused ? std::nullopt : std::optional(NetlistLayout(syntax).written());
}

} // namespace placedpar
