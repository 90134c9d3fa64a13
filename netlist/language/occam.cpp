#include "netlist/language/occam.hpp"

#include "netlist/language/characters.hpp"
#include "text/nearest.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace placedpar {

namespace {

/// Says what a line tells about a text: nothing, or that the text is occam of some kind. The value for a text is the
/// highest value among its lines.
enum class Dialect { none, comment, program, toolset, development_system };

constexpr const char* hint_for(Dialect dialect) {
    switch (dialect) {
    case Dialect::development_system: return "to run this file, give it a name that ends in .occ or .pgm";
    case Dialect::toolset: return "to run this configuration, give its file a name that ends in .pgm";
    default:
        return "placedpar run executes a program in occam if its file's name ends in .occ; a netlist uses it as a "
               "process: use \"FILE.occ\" for name;";
    }
}

std::string_view without_blanks(std::string_view line) {
    auto first = line.find_first_not_of(" \t");
    return first == line.npos ? "" : line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

template <std::size_t size>
bool begins_with_any(std::string_view line, const std::array<std::string_view, size>& beginnings) {
    return std::ranges::any_of(beginnings, [&](auto beginning) { return line.starts_with(beginning); });
}

template <std::size_t size>
bool is_any(std::string_view line, const std::array<std::string_view, size>& words) {
    return std::ranges::find(words, line) != words.end();
}

/// Returns true for a line such as `PROCESSOR 0 T8`.
bool is_processor(std::string_view line) {
    constexpr std::string_view word = "PROCESSOR ";
    auto number = line.starts_with(word) ? without_blanks(line.substr(word.size())) : "";
    return !number.empty() && is_digit(number.front());
}

/// Returns true for a line that includes an occam library, such as `#INCLUDE "hostio.inc"`, which a netlist never does.
bool includes_library(std::string_view line) {
    static constexpr std::array<std::string_view, 7> libraries{
        "hostio.inc", "streamio.inc", "linkaddr.inc", "mathvals.inc", "ticonst.inc", "msdos.inc", "occonf.inc"};
    auto quote = line.starts_with("#INCLUDE") ? line.find('"') : line.npos;
    if (quote == line.npos)
        return false;
    auto name = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
    return is_any(lower_case(name), libraries);
}

bool is_of_program(std::string_view line) {
    static constexpr std::array<std::string_view, 17> beginnings{
        "#USE ", "#SC ",  "#OPTION ", "#PRAGMA ", "#IMPORT ", "CHAN ",  "PROTOCOL ", "PROC ", "VAL ",
        "INT ",  "BYTE ", "BOOL ",    "REAL32 ",  "REAL64 ",  "TIMER ", "WHILE ",    "PRI "};
    static constexpr std::array<std::string_view, 4> words{"SEQ", "PAR", "ALT", "IF"};
    return begins_with_any(line, beginnings) || is_any(line, words) || includes_library(line);
}

bool is_of_toolset(std::string_view line) {
    static constexpr std::array<std::string_view, 6> beginnings{"NODE ",    "ARC ",     "EDGE ",
                                                                "NETWORK ", "MAPPING ", "CONFIG "};
    static constexpr std::array<std::string_view, 3> words{"CONFIG", "NETWORK", "MAPPING"};
    return begins_with_any(line, beginnings) || is_any(line, words);
}

bool is_statement_of_netlist(std::string_view line) { return line.ends_with(';'); }

/// Returns true for a comment and for a fold. The editor of the transputer development system writes an open fold as
/// `{{{ name` and a closed fold as `... name`.
bool is_comment_or_fold(std::string_view line) {
    static constexpr std::array<std::string_view, 3> beginnings{"--", "{{{ ", "..."};
    return begins_with_any(line, beginnings);
}

Dialect dialect_of(std::string_view line) {
    if (is_statement_of_netlist(line))
        return Dialect::none;
    if (line.starts_with("PLACED PAR") || is_processor(line))
        return Dialect::development_system;
    if (is_of_toolset(line))
        return Dialect::toolset;
    if (is_of_program(line))
        return Dialect::program;
    return is_comment_or_fold(line) ? Dialect::comment : Dialect::none;
}

/// Returns whether a comment of C is open at the end of the line. `open` is true if a comment is open at its beginning.
bool comment_goes_on(std::string_view line, bool open) {
    auto start = line.rfind("/*"), end = line.rfind("*/");
    if (start == line.npos)
        return open && end == line.npos;
    return end == line.npos || end < start;
}

/// Looks for the first line that only occam can have, and for the first occam comment.
class OccamSearch {
public:
    void take(std::string_view words, const Location& at) {
        Dialect dialect = dialect_of(words);
        has_statement_ |= is_statement_of_netlist(words);
        if (dialect == Dialect::comment && !comment_)
            comment_ = at;
        else if (dialect > Dialect::comment && !line_)
            line_ = at;
        dialect_ = std::max(dialect_, dialect);
    }

    /// Returns the first sign of occam; nothing if there is none. A comment counts only if the text has no statement of
    /// a netlist, since a netlist may contain an occam comment by mistake.
    std::optional<Occam> result() const {
        if (line_)
            return Occam{*line_, hint_for(dialect_)};
        if (comment_ && !has_statement_)
            return Occam{*comment_, hint_for(dialect_)};
        return std::nullopt;
    }

private:
    Dialect dialect_ = Dialect::none;
    std::optional<Location> line_, comment_;
    bool has_statement_ = false;
};

} // namespace

std::optional<Occam> occam_in(const std::shared_ptr<const SourceFile>& file) {
    auto lines = static_cast<std::size_t>(std::ranges::count(file->text(), '\n')) + 1;
    OccamSearch search;
    bool in_comment = false;
    for (std::size_t number = 1; number <= lines; ++number) {
        auto line = file->line(number), words = without_blanks(line);
        if (!in_comment && !words.empty())
            search.take(words, {file, number, static_cast<std::size_t>(words.data() - line.data()) + 1});
        in_comment = comment_goes_on(line, in_comment);
    }
    return search.result();
}

} // namespace placedpar
