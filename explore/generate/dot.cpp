#include "explore/generate/graph.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace placedpar::generate {

namespace {

/// A word of Graphviz's language DOT: a mark such as "{" or "--", or an ID, whose quotes are removed.
struct DotWord {
    std::string text;
    bool is_mark = false;
    bool is_quoted = false; ///< a quoted word is not a keyword
    std::size_t line = 0;

    bool is(std::string_view mark) const { return is_mark && text == mark; }
    bool is_keyword(std::string_view word) const { return !is_mark && !is_quoted && lower_case(text) == word; }
    bool is_end() const { return is_mark && text.empty(); }
};

class DotWords {
public:
    explicit DotWords(std::shared_ptr<const SourceFile> file) : file_(std::move(file)), left_(file_->text()) {
        next_ = read();
    }

    const DotWord& peek() const { return next_; }
    DotWord take() {
        taken_line_ = next_.line;
        return std::exchange(next_, read());
    }
    bool take_if(std::string_view mark) {
        const bool follows = next_.is(mark);
        if (follows)
            take();
        return follows;
    }
    /// Refuses the word that was taken last.
    [[noreturn]] void refuse_taken(const std::string& message, const std::string& hint = "") const {
        refuse_graph(file_, taken_line_, message, hint);
    }
    /// Refuses the word that peek() returns.
    [[noreturn]] void refuse_next(const std::string& message, const std::string& hint = "") const {
        refuse_graph(file_, next_.line, message, hint);
    }

private:
    /// Refuses the characters that are read now.
    [[noreturn]] void refuse(const std::string& message, const std::string& hint = "") const {
        refuse_graph(file_, line_, message, hint);
    }

    void drop(std::size_t bytes) {
        bytes = std::min(bytes, left_.size());
        line_ += static_cast<std::size_t>(std::ranges::count(left_.substr(0, bytes), '\n'));
        left_.remove_prefix(bytes);
    }

    /// Skips blanks, comments, and lines of a preprocessor.
    void skip() {
        for (;;) {
            const std::size_t blanks = std::min(left_.find_first_not_of(" \t\r\n;,"), left_.size());
            drop(blanks);
            if (left_.starts_with("//") || left_.starts_with('#'))
                drop(left_.find('\n'));
            else if (left_.starts_with("/*"))
                drop(closing("*/", 2, "a comment"));
            else
                return;
        }
    }

    std::size_t closing(std::string_view end, std::size_t from, const char* what) const {
        const std::size_t found = left_.find(end, from);
        if (found == left_.npos)
            refuse(fmt::format("{} is not closed", what));
        return found + end.size();
    }

    DotWord read() {
        skip();
        DotWord word{.text = "", .is_mark = true, .line = line_};
        if (left_.empty())
            return word;
        for (const std::string_view mark : {"--", "->", "{", "}", "[", "]", "=", ":", "+"})
            if (left_.starts_with(mark)) {
                word.text = mark;
                drop(mark.size());
                return word;
            }
        word.is_mark = false;
        word.is_quoted = left_.front() == '"' || left_.front() == '<';
        word.text = left_.front() == '"' ? quoted() : left_.front() == '<' ? html() : plain();
        return word;
    }

    /// Reads a string in quotes, or several such strings that are joined by "+".
    std::string quoted() {
        std::string text;
        do {
            std::size_t end = 1;
            for (; end < left_.size() && left_[end] != '"'; ++end) {
                if (left_[end] == '\\' && end + 1 < left_.size() && (left_[end + 1] == '"' || left_[end + 1] == '\n'))
                    ++end;
                if (left_[end] != '\n')
                    text += left_[end];
            }
            if (end >= left_.size())
                refuse("a string is not closed");
            drop(end + 1);
            skip();
        } while (joins_string());
        return text;
    }

    bool joins_string() {
        if (!left_.starts_with('+'))
            return false;
        drop(1);
        skip();
        if (!left_.starts_with('"'))
            refuse("\"+\" is not followed by a string");
        return true;
    }

    std::string html() {
        std::size_t open = 0, end = 0;
        do {
            open += left_[end] == '<' ? 1U : 0U;
            open -= left_[end] == '>' ? 1U : 0U;
        } while (++end < left_.size() && open > 0);
        if (open > 0)
            refuse("a string in < > is not closed");
        std::string text(left_.substr(0, end));
        drop(end);
        return text;
    }

    static bool belongs_to_name(char each) {
        return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z') || (each >= '0' && each <= '9') ||
               each == '_' || each == '.' || (static_cast<unsigned char>(each) & 0x80) != 0;
    }

    std::string plain() {
        auto begins_number = [](char each) { return (each >= '0' && each <= '9') || each == '.'; };
        std::size_t end = left_.front() == '-' && left_.size() > 1 && begins_number(left_[1]) ? 1 : 0;
        while (end < left_.size() && belongs_to_name(left_[end]))
            ++end;
        if (end == 0)
            refuse(fmt::format("\"{}\" is not expected here", left_.substr(0, 1)),
                   left_.front() == '-' ? "an edge is written \"--\" or \"->\"; a name with \"-\" needs quotes" : "");
        std::string text(left_.substr(0, end));
        drop(end);
        return text;
    }

    std::shared_ptr<const SourceFile> file_;
    std::string_view left_;
    std::size_t line_ = 1, taken_line_ = 1; ///< line of the next character, and of the word that was taken last
    DotWord next_;
};

class DotReader {
public:
    explicit DotReader(const std::shared_ptr<const SourceFile>& file) : words_(file), builder_(file) {}

    Graph read() {
        if (words_.peek().is_keyword("strict")) {
            strict_ = true;
            words_.take();
        }
        const DotWord kind = words_.take();
        if (!kind.is_keyword("graph") && !kind.is_keyword("digraph"))
            words_.refuse_taken("expected \"graph\" or \"digraph\"",
                                "the file must be a graph in DOT, the language of Graphviz");
        builder_.graph().directed = kind.is_keyword("digraph");
        if (!words_.peek().is_mark)
            words_.take();
        if (!words_.take_if("{"))
            words_.refuse_next("expected \"{\" before the statements of the graph");
        read_statements({});
        if (!words_.peek().is_end())
            words_.refuse_next("the file continues after the end of the graph", "a file can have only one graph");
        return std::move(builder_.graph());
    }

private:
    using Nodes = std::set<std::size_t>;
    struct Defaults {
        GraphAttributes node, edge;
    };

    /// Reads statements up to their "}", and returns all nodes in them. `defaults` is a copy, because the defaults that
    /// a subgraph sets are valid only in the subgraph.
    Nodes read_statements(Defaults defaults) {
        if (++depth_ > deepest_graph)
            words_.refuse_taken(fmt::format("subgraphs are nested deeper than {} levels", deepest_graph));
        Nodes nodes;
        while (!words_.take_if("}")) {
            if (words_.peek().is_end())
                words_.refuse_next("the graph is not closed: \"}\" is missing");
            nodes.merge(read_statement(defaults));
        }
        --depth_;
        return nodes;
    }

    Nodes read_statement(Defaults& defaults) {
        for (auto [word, attributes] : {std::pair("node", &defaults.node), std::pair("edge", &defaults.edge)})
            if (words_.peek().is_keyword(word)) {
                words_.take();
                read_attributes(*attributes);
                return {};
            }
        if (words_.peek().is_keyword("graph")) {
            GraphAttributes unused;
            words_.take();
            read_attributes(unused);
            return {};
        }
        return read_nodes_or_edges(defaults);
    }

    Nodes read_nodes_or_edges(Defaults& defaults) {
        const std::size_t line = words_.peek().line;
        std::vector<Nodes> ends{read_end(defaults)};
        if (words_.take_if("=")) { // an attribute of the graph
            words_.take();
            return {};
        }
        while (words_.peek().is("--") || words_.peek().is("->")) {
            take_edge_mark();
            ends.push_back(read_end(defaults));
        }
        if (ends.size() > 1) {
            builder_.count_copy(defaults.edge, line);
            GraphAttributes attributes = defaults.edge;
            read_attributes(attributes);
            add_edges(ends, attributes, line);
        } else if (words_.peek().is("[")) {
            GraphAttributes attributes;
            read_attributes(attributes);
            for (const std::size_t node : ends.front()) {
                builder_.count_copy(attributes, line);
                for (const auto& [name, value] : attributes)
                    builder_.graph().nodes[node].attributes[name] = value;
            }
        }
        Nodes all;
        for (Nodes& each : ends)
            all.merge(each);
        return all;
    }

    void take_edge_mark() {
        const bool directed = builder_.graph().directed;
        if (words_.peek().is(directed ? "--" : "->"))
            words_.refuse_next(directed ? "the edge of a digraph is written \"--\""
                                        : "the edge of a graph is written \"->\"",
                               directed ? "write \"->\", or begin the file with \"graph\""
                                        : "write \"--\", or begin the file with \"digraph\"");
        words_.take();
    }

    /// Reads a node, or a subgraph.
    Nodes read_end(const Defaults& defaults) {
        if (words_.peek().is_keyword("subgraph")) {
            words_.take();
            if (!words_.peek().is_mark)
                words_.take();
        }
        const std::size_t line = words_.peek().line;
        if (words_.take_if("{")) {
            builder_.count_copy(defaults.node, line);
            builder_.count_copy(defaults.edge, line);
            return read_statements(defaults);
        }
        const DotWord name = words_.take();
        if (name.is_mark)
            words_.refuse_taken(name.is_end() ? "the graph is not closed: \"}\" is missing"
                                              : fmt::format("\"{}\" is not expected here", name.text));
        while (words_.take_if(":")) // skips a port and a compass point
            words_.take();
        if (words_.peek().is("="))
            return {};
        const bool is_new = !builder_.has(name.text);
        const std::size_t node = builder_.node(name.text, name.line);
        if (is_new) {
            builder_.count_copy(defaults.node, name.line);
            builder_.graph().nodes[node].attributes = defaults.node;
        }
        return {node};
    }

    void read_attributes(GraphAttributes& attributes) {
        while (words_.take_if("["))
            while (!words_.take_if("]")) {
                const DotWord name = words_.take();
                if (name.is_mark)
                    words_.refuse_taken("expected an attribute, or \"]\"");
                const bool has_value = words_.take_if("=");
                const DotWord value = has_value ? words_.take() : DotWord{.text = "true"};
                if (value.is_mark)
                    words_.refuse_taken(fmt::format("the attribute \"{}\" has no value", name.text));
                attributes[name.text] = value.text;
            }
    }

    void add_edges(const std::vector<Nodes>& ends, const GraphAttributes& attributes, std::size_t line) {
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            for (const std::size_t from : ends[i])
                for (const std::size_t to : ends[i + 1]) {
                    if (++pairs_ > 10 * most_graph_elements)
                        words_.refuse_taken("the graph joins too many pairs of nodes");
                    if (strict_ && !known_.insert(pair_of(from, to)).second)
                        continue;
                    builder_.count_copy(attributes, line);
                    builder_.add_edge({from, to, attributes, line});
                }
    }

    std::pair<std::size_t, std::size_t> pair_of(std::size_t from, std::size_t to) {
        return builder_.graph().directed || from < to ? std::pair(from, to) : std::pair(to, from);
    }

    DotWords words_;
    GraphBuilder builder_;
    bool strict_ = false;
    std::size_t depth_ = 0, pairs_ = 0;
    std::set<std::pair<std::size_t, std::size_t>> known_;
};

} // namespace

Graph read_dot(const std::shared_ptr<const SourceFile>& file) { return DotReader(file).read(); }

} // namespace placedpar::generate
