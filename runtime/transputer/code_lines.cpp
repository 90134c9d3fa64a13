#include "runtime/transputer/code_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>

namespace placedpar::transputer {
namespace {

constexpr std::size_t longest_table_name = 200;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Takes the words of a row, from left to right.
class TableRow {
public:
    TableRow(std::string_view text, std::size_t line) : text_(text), line_(line) { skip(); }

    bool at_end() const { return at_ == text_.size(); }
    bool is_comment() const { return at_end() || text_.substr(at_).starts_with("--"); }
    [[noreturn]] void refuse(const std::string& why, std::size_t at) const { throw CodeLinesError(why, line_, at + 1); }

    std::string_view word(const char* what) {
        if (at_end())
            refuse(fmt::format("the row is cut off: it has no {}", what), at_);
        last_ = at_;
        while (!at_end() && !is_blank(text_[at_]))
            ++at_;
        const std::string_view result = text_.substr(last_, at_ - last_);
        skip();
        return result;
    }

    Word address(const char* what, Word memory_start) {
        std::string_view digits = word(what);
        const bool is_relative = digits.starts_with('+');
        digits.remove_prefix(is_relative ? 1 : 0);
        const auto value = digits.starts_with('#') ? number<Word>(digits.substr(1), 16) : std::nullopt;
        if (!value || (is_relative && *value > ~memory_start) || (!is_relative && *value < most_negative))
            refuse(
                fmt::format("{} is not an address such as #80000170, or an offset from MemStart such as +#100", what),
                last_);
        return is_relative ? memory_start + *value : *value;
    }

    std::uint32_t count(const char* what) {
        const auto value = number<std::uint32_t>(word(what), 10);
        if (!value || *value == 0)
            refuse(fmt::format("{} is not a whole number of at least 1", what), last_);
        return *value;
    }

    /// Takes the rest of the row.
    std::string name(const char* what) {
        if (at_end())
            refuse(fmt::format("the row is cut off: it has no {}", what), at_);
        std::string_view rest = text_.substr(at_);
        while (is_blank(rest.back()))
            rest.remove_suffix(1);
        if (rest.size() > longest_table_name)
            refuse(fmt::format("{} has more than {} bytes", what, longest_table_name), at_);
        if (std::ranges::any_of(rest, [](char c) { return (c >= 0 && c < ' ') || c == 0x7f; }))
            refuse(fmt::format("{} has a control character", what), at_);
        at_ = text_.size();
        return std::string(rest);
    }

    void end() const {
        if (!at_end())
            refuse("the row is complete before this word: delete the rest of the line", at_);
    }

private:
    template <class Number>
    static std::optional<Number> number(std::string_view digits, int base) {
        Number result = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result, base);
        return error == std::errc{} && end == digits.data() + digits.size() ? std::optional(result) : std::nullopt;
    }
    void skip() {
        while (!at_end() && is_blank(text_[at_]))
            ++at_;
    }

    std::string_view text_;
    std::size_t line_, at_ = 0, last_ = 0;
};

} // namespace

/// Reads a table, and keeps the rows of one node.
class CodeLines::Reader {
public:
    Reader(std::string_view node, Word memory_start) : node_(node), memory_start_(memory_start) {}

    CodeLines read(std::string_view table) {
        for (std::size_t line = 1; !ended_; ++line) {
            if (table.empty())
                throw CodeLinesError("the table is cut off: its last row must be \"end\"", line, 1);
            const std::size_t length = std::min(table.find('\n'), table.size());
            TableRow row(table.substr(0, length), line);
            table.remove_prefix(std::min(length + 1, table.size()));
            if (!row.is_comment())
                read_row(row, line);
        }
        end_section();
        return std::move(kept_);
    }

private:
    void read_row(TableRow& row, std::size_t line) {
        const std::string_view kind = row.word("kind");
        if (kind == "code")
            section_.code_.push_back(code(row, line));
        else if (kind == "entry")
            section_.entries_.push_back(entry(row, line));
        else if (kind == "error")
            section_.errors_.push_back(entry(row, line));
        else if (kind == "process" || kind == "carrier")
            section_.processes_.push_back(process(row, line, kind == "carrier"));
        else if (kind == "channel")
            section_.channels_.push_back(entry(row, line));
        else if (kind == "node")
            begin_section(row);
        else if (kind == "end")
            ended_ = true;
        else
            row.refuse("a row begins with code, entry, process, carrier, channel, error, node or end", 0);
        row.end();
    }

    Row code(TableRow& row, std::size_t line) {
        Row result = range(row, line);
        const std::uint32_t of_line = row.count("LINE"), column = row.count("COLUMN");
        result.text = fmt::format("{}:{}:{}", row.name("FILE"), of_line, column);
        return result;
    }

    Row process(TableRow& row, std::size_t line, bool is_carrier) {
        Row result = range(row, line);
        result.is_carrier = is_carrier;
        result.text = row.name("NAME");
        return result;
    }

    Row entry(TableRow& row, std::size_t line) {
        const Word at = row.address("ADDRESS", memory_start_);
        return {at, at, row.name("NAME"), line, false};
    }

    Row range(TableRow& row, std::size_t line) {
        const Word from = row.address("FROM", memory_start_), until = row.address("UNTIL", memory_start_);
        if (from >= until)
            row.refuse("UNTIL is not after FROM", 0);
        return {from, until, "", line, false};
    }

    void begin_section(TableRow& row) {
        end_section();
        name_ = row.name("NAME");
        if (!names_.insert(name_).second)
            row.refuse(fmt::format("the node \"{}\" has rows already: put all rows of a node together", name_), 0);
    }

    void end_section() {
        sort(section_.code_);
        sort(section_.entries_);
        sort(section_.processes_);
        sort(section_.errors_);
        sort(section_.channels_);
        if (name_ == node_)
            kept_ = std::move(section_);
        section_ = {};
    }

    static void sort(std::vector<Row>& rows) {
        std::ranges::stable_sort(rows, {}, &Row::from);
        for (std::size_t i = 1; i < rows.size(); ++i)
            if (rows[i].from < rows[i - 1].until || rows[i].from == rows[i - 1].from)
                throw CodeLinesError(fmt::format("the row has an address that the row in line {} has already",
                                                 std::min(rows[i].line, rows[i - 1].line)),
                                     std::max(rows[i].line, rows[i - 1].line), 1);
    }

    std::string_view node_;
    Word memory_start_;
    std::string name_;
    std::set<std::string> names_;
    CodeLines section_, kept_;
    bool ended_ = false;
};

namespace {

/// Returns the last row that begins at or before an address; null if there is none.
template <class Rows>
auto row_before(const Rows& rows, Word address) {
    const auto after =
        std::upper_bound(rows.begin(), rows.end(), address, [](Word at, const auto& row) { return at < row.from; });
    return after == rows.begin() ? nullptr : &*std::prev(after);
}

} // namespace

CodeLines::CodeLines(std::string_view table, std::string_view node, Word memory_start)
    : CodeLines(Reader(node, memory_start).read(table)) {}

std::string CodeLines::file_place(Word address) const {
    const Row* row = row_before(code_, address);
    return row && address < row->until ? row->text : "";
}

std::string CodeLines::place(Word address) const {
    if (std::string place = file_place(address); !place.empty())
        return place;
    const Row* procedure = row_before(entries_, address);
    return procedure ? fmt::format("{}+#{:X}", procedure->text, address - procedure->from) : "";
}

std::string CodeLines::entry(Word address) const {
    const Row* row = row_before(entries_, address);
    return row && row->from == address ? row->text : "";
}

bool CodeLines::is_carrier(Word workspace) const {
    const Row* row = row_before(processes_, workspace);
    return row && workspace < row->until && row->is_carrier;
}

std::string CodeLines::channel(Word word) const {
    const Row* row = row_before(channels_, word);
    return row && row->from == word ? row->text : "";
}

std::string CodeLines::process(Word workspace) const {
    const Row* row = row_before(processes_, workspace);
    return row && workspace < row->until ? row->text : "";
}

std::string_view CodeLines::error(Word address) const {
    const Row* row = row_before(errors_, address);
    return row && row->from == address ? std::string_view(row->text) : "";
}

} // namespace placedpar::transputer
