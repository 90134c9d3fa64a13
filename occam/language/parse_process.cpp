#include "occam/language/parser.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar::occam {

Process Parser::parse_process() {
    const Nesting nesting(*this);
    return is_declaration(false) ? parse_scope() : parse_statement();
}

/// Reads declarations and the process that follows them at the same indentation.
Process Parser::parse_scope() {
    const Word first = peek();
    Scope scope;
    parse_declarations(scope.declarations, false);
    const Word& next = peek();
    if (is_at_end() || next.indentation < first.indentation || next.is(":") || next.is_word("RESULT"))
        refuse(last_, "a process is missing after the declaration", "write it below, at the same indentation");
    if (next.indentation > first.indentation && !indentation_in_doubt_)
        reading_.reporter.error(at(next), "a process must have the same indentation as the declarations before it", "",
                                {{"the declaration is here", at(first)}});
    scope.process = std::make_unique<Process>(parse_statement());
    return {first.at, std::move(scope)};
}

Process Parser::parse_statement() {
    const Word first = peek();
    if (is_foreign_statement())
        refuse_unread(first, "a process");
    Process process{first.at, Skip{}};
    if (accept_word("SKIP"))
        end_line("SKIP");
    else if (accept_word("STOP")) {
        process.form = Stop{};
        end_line("STOP");
    } else if (first.is_word("SEQ"))
        return parse_sequence_process();
    else if (first.is_word("PAR"))
        return parse_parallel(Parallel::Kind::plain);
    else if (first.is_word("PLACED"))
        return parse_parallel(Parallel::Kind::placed);
    else if (first.is_word("PRI") && peek(1).is_word("PAR"))
        return parse_parallel(Parallel::Kind::priority);
    else if (first.is_word("ALT") || (first.is_word("PRI") && peek(1).is_word("ALT")))
        process.form = parse_alternation(first.is_word("PRI"));
    else if (first.is_word("IF"))
        process.form = parse_if();
    else if (first.is_word("CASE"))
        return parse_case();
    else if (first.is_word("WHILE"))
        return parse_while();
    else if (first.is_word("PROCESSOR"))
        return parse_processor();
    else if (is_do())
        return parse_sequence_process();
    else if (is_wiring())
        return parse_wiring();
    else if (first.kind == WordKind::name && peek(1).is("("))
        return parse_instance();
    else if (first.kind == WordKind::name || first.is("["))
        return parse_assignment_or_communication();
    else
        refuse_statement(first);
    return process;
}

/// Refuses a line that begins neither a process nor a declaration.
void Parser::refuse_statement(const Word& word) {
    static const std::vector<std::string> beginnings = {"SEQ",   "PAR",  "PRI",  "ALT",      "IF",    "CASE",
                                                        "WHILE", "SKIP", "STOP", "VAL",      "PROC",  "CHAN",
                                                        "INT",   "BYTE", "BOOL", "PROTOCOL", "TIMER", "PLACED"};
    const bool is_name = word.kind == WordKind::name;
    std::string upper(word.text);
    std::ranges::transform(upper, upper.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    std::string hint = is_name ? did_you_mean(word.text, beginnings) : "";
    if (is_name && upper != word.text && is_keyword(upper))
        hint = fmt::format("write the words of the language in capitals: {}", upper);
    if (word.is_word("ELSE"))
        hint = "ELSE is an option of CASE; write TRUE in an IF";
    if (hint.empty() && is_name && peek(1).kind == WordKind::end)
        hint = fmt::format("write the call of a PROC with parentheses: {} ()", word.text);
    if (word.is_word("PRI"))
        hint = "write PRI PAR or PRI ALT";
    refuse(word, fmt::format("a process or a declaration is expected: found {}", describe(word)), hint);
}

Process Parser::parse_sequence_process() {
    const Word head = take();
    Sequence sequence;
    sequence.is_do = head.is_word("DO");
    parse_header([&] {
        sequence.replicator = parse_replicator();
        end_line(head.text);
    });
    if (sequence.replicator)
        sequence.processes.push_back(std::move(*parse_body(head)));
    else
        parse_block(head, [&] { sequence.processes.push_back(parse_process()); });
    return {head.at, std::move(sequence)};
}

Process Parser::parse_parallel(Parallel::Kind kind) {
    const Word head = take();
    Parallel parallel{.kind = kind, .replicator = {}, .processes = {}};
    parse_header([&] {
        if (kind != Parallel::Kind::plain)
            expect_word("PAR", fmt::format("after {}", head.text));
        parallel.replicator = parse_replicator();
        end_line("PAR");
    });
    if (parallel.replicator)
        parallel.processes.push_back(std::move(*parse_body(head)));
    else
        parse_block(head, [&] { parallel.processes.push_back(parse_process()); });
    return {head.at, std::move(parallel)};
}

std::optional<Replicator> Parser::parse_replicator() {
    if (peek().kind == WordKind::end)
        return std::nullopt;
    const Word name = peek();
    auto index = std::make_unique<Declaration>();
    index->at = name.at;
    index->name = expect_name("an index");
    index->form = ReplicatorIndex{};
    expect("=", "after the index of a replicator");
    Replicator replicator{.index = std::move(index), .base = parse_expression(), .count = {}, .step = nullptr};
    expect_word("FOR", "in a replicator");
    replicator.count = parse_expression();
    if (accept_word("STEP"))
        replicator.step = std::make_unique<Expression>(parse_expression());
    return replicator;
}

Process Parser::parse_case() {
    const Word head = take();
    Case process;
    parse_header([&] {
        process.selector = parse_expression();
        end_line("the selector");
    });
    parse_block(head, [&] { parse_option(process); });
    return {head.at, std::move(process)};
}

void Parser::parse_option(Case& process) {
    Option option;
    parse_declarations(option.declarations, true);
    const Word head = peek();
    option.at = head.at;
    parse_header([&] {
        if (!accept_word("ELSE"))
            option.values = parse_expressions();
        end_line("an option of CASE");
    });
    option.process = parse_body(head);
    process.options.push_back(std::move(option));
}

Process Parser::parse_while() {
    const Word head = take();
    While process;
    parse_header([&] {
        process.condition = parse_expression();
        end_line("the condition of WHILE");
    });
    process.process = parse_body(head);
    return {head.at, std::move(process)};
}

Process Parser::parse_instance() {
    const Word name = take();
    take();
    Instance instance{std::string(name.text), parse_arguments()};
    end_line("the arguments");
    return {name.at, std::move(instance)};
}

namespace {

/// Returns a hint for `x += 1` of other languages; "" for other text.
std::string hint_for_change(const Word& variable, const Word& operation, const Word& next) {
    const bool changes = operation.is("+") || operation.is("-") || operation.is("*") || operation.is("/");
    return changes && (next.is("=") || next.is(operation.text))
               ? fmt::format("write {0} := {0} {1} ...", variable.text, operation.text)
               : "";
}

} // namespace

Process Parser::parse_assignment_or_communication() {
    const Word first = peek();
    const bool stands_alone = peek(1).kind == WordKind::name || peek(1).kind == WordKind::end ||
                              peek(1).kind == WordKind::integer || peek(1).kind == WordKind::keyword;
    if (first.kind == WordKind::name && stands_alone)
        refuse_statement(first);
    Expression target = parse_element("a variable or channel");
    if (accept("?"))
        return parse_input(std::move(target), first);
    if (accept("!"))
        return parse_output(std::move(target));
    Assignment assignment;
    assignment.targets.push_back(std::move(target));
    while (accept(","))
        assignment.targets.push_back(parse_element("a variable"));
    if (!accept(":="))
        refuse(peek(), fmt::format("\":=\", \"?\" or \"!\" is expected: found {}", describe(peek())),
               peek().is("=") ? "write \":=\" for an assignment" : hint_for_change(first, peek(), peek(1)));
    assignment.values = parse_expressions();
    end_line("an assignment");
    return {first.at, std::move(assignment)};
}

/// Reads a name or a segment, with subscripts.
Expression Parser::parse_element(std::string_view what) {
    const Word word = peek();
    if (word.kind == WordKind::keyword)
        refuse(word, fmt::format("\"{}\" is a word of the language and cannot be the name of {}", word.text, what));
    if (word.is("["))
        return parse_operand();
    const std::string name = expect_name(what);
    return parse_subscripts(made(word, NameUse{name}));
}

Process Parser::parse_input(Expression channel, const Word& head) {
    const Place start = head.at;
    if (accept_word("AFTER")) {
        Delay delay{std::move(channel), parse_expression()};
        end_line("a time");
        return {start, std::move(delay)};
    }
    if (accept_word("CASE")) {
        VariantInput input{std::move(channel), {}};
        parse_variants(input, head);
        return {start, std::move(input)};
    }
    Input input{std::move(channel), parse_items()};
    end_line("an input");
    return {start, std::move(input)};
}

Process Parser::parse_output(Expression channel) {
    const Place start = channel.at;
    Output output{.channel = std::move(channel), .items = parse_items(), .tag_value = {}};
    end_line("an output");
    return {start, std::move(output)};
}

std::vector<Item> Parser::parse_items() {
    std::vector<Item> items;
    do
        items.push_back(parse_item());
    while (accept(";"));
    return items;
}

Item Parser::parse_item() {
    Item item{.value = parse_expression(), .counted_array = nullptr};
    if (accept("::"))
        item.counted_array = std::make_unique<Expression>(parse_expression());
    return item;
}

} // namespace placedpar::occam
