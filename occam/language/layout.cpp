#include "occam/language/parser.hpp"

#include "text/counted.hpp"

#include <fmt/format.h>

namespace placedpar::occam {

namespace {

constexpr std::uint32_t indentation_step = 2;

} // namespace

/// Continues after a refused statement, at the next line that is not indented further than `indentation`. `line` is the
/// number of lines that had been read before the statement.
void Parser::recover(std::uint32_t indentation, std::size_t line) {
    if (line == lines_taken_ || !is_at_line_start())
        next_line();
    while (!is_at_end() && peek().indentation > indentation)
        next_line();
}

/// Reads the line of a construct, such as WHILE. If the line is refused, its block is still read.
void Parser::parse_header(const Component& header) {
    const std::size_t line = lines_taken_;
    try {
        header();
        header_failed_ = false;
    } catch (const LineRefused&) {
        header_failed_ = true;
        if (line == lines_taken_ || !is_at_line_start())
            next_line();
    }
}

/// Returns whether the next line belongs to the block below a line with this indentation.
bool Parser::block_goes_on(std::uint32_t indentation) const {
    return !is_at_end() && peek().indentation > indentation && !peek().is(":") && !peek().is(")");
}

/// Returns the indentation of the first line of a block, even if it is wrong, so that the block can still be read.
std::uint32_t Parser::adopt_indentation(const Word& first, const Word& head) {
    const std::uint32_t wanted = head.indentation + indentation_step;
    if (first.indentation != wanted && !indentation_in_doubt_)
        check_indentation(first, wanted, head);
    return first.indentation;
}

void Parser::check_indentation(const Word& first, std::uint32_t wanted, const Word& head) {
    reading_.reporter.error(
        at(first),
        fmt::format("wrong indentation: the line begins with {}, but {} are expected",
                    counted(first.indentation, "blank"), wanted),
        fmt::format("indent the lines below \"{0}\" by two blanks more than the line of \"{0}\"", head.text),
        {{fmt::format("the \"{}\" is here", head.text), at(head)}});
}

/// Reads the block below the line of `head`. The lines of the block must be indented by two blanks more. REQUIRES: the
/// line of `head` has been read to its end.
void Parser::parse_block(const Word& head_word, const Component& component) {
    const Word head = head_word;
    const bool doubt = indentation_in_doubt_;
    std::optional<std::uint32_t> own, reported;
    while (block_goes_on(head.indentation)) {
        const Word first = peek();
        if (!own)
            own = adopt_indentation(first, head);
        const bool is_wrong = first.indentation != *own;
        if (is_wrong && !doubt && first.indentation != reported)
            check_indentation(first, *own, head);
        if (is_wrong)
            reported = first.indentation;
        indentation_in_doubt_ = doubt || is_wrong;
        const std::size_t line = lines_taken_;
        try {
            component();
        } catch (const LineRefused&) {
            recover(first.indentation, line);
        }
        if (line == lines_taken_ && is_at_line_start()) // nothing was read
            next_line();
    }
    indentation_in_doubt_ = doubt;
}

/// Reads the one process below the line of `head`.
ProcessBox Parser::parse_body(const Word& head) {
    ProcessBox body;
    bool is_empty = !std::exchange(header_failed_, false), has_more = false;
    parse_block(head, [&] {
        is_empty = false;
        const Word first = peek();
        if (body && !std::exchange(has_more, true) && !indentation_in_doubt_)
            reading_.reporter.error(
                at(first), fmt::format("only one process is allowed below \"{}\"", head.text),
                fmt::format("put {} above both, and indent them by two blanks more",
                            head.is_word("NETWORK") || head.is_word("MAPPING") ? "DO" : "SEQ or PAR"),
                {{"the first process is here", reading_.location(body->at)}});
        Process process = parse_process();
        if (!body)
            body = std::make_unique<Process>(std::move(process));
    });
    if (is_empty)
        reading_.reporter.error(at(head), fmt::format("a process is missing below \"{}\"", head.text),
                                "if nothing must be done, write SKIP, indented by two blanks more");
    const bool is_meant = head.is_word("WHILE") || head.is_word("SEQ") || head.is_word("PAR");
    if (is_empty && is_meant && !is_at_end() && peek().indentation == head.indentation && !peek().is(":"))
        body = std::make_unique<Process>(parse_process()); // the process below is not indented, although it should be
    return body ? std::move(body) : std::make_unique<Process>(Process{head.at, Skip{}});
}

} // namespace placedpar::occam
