#include "occam/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::occam {

If Parser::parse_if() {
    const Word head = take();
    const bool has_condition = peek().kind != WordKind::end &&
                               std::ranges::none_of(line_.words, [](const Word& each) { return each.is_word("FOR"); });
    If process;
    parse_header([&] {
        if (has_condition)
            refuse(peek(), "a condition of IF must be on a line of its own",
                   "write IF alone on its line, the condition on the next line, and its process below the condition");
        process.replicator = parse_replicator();
        end_line("IF");
    });
    if (has_condition)
        parse_block(head, [&] { parse_process(); });
    else
        parse_block(head, [&] { process.choices.push_back(parse_choice()); });
    return process;
}

Choice Parser::parse_choice() {
    const Nesting nesting(*this);
    Choice choice;
    parse_declarations(choice.declarations, true);
    choice.at = peek().at;
    if (peek().is_word("IF")) {
        choice.nested = std::make_unique<If>(parse_if());
        return choice;
    }
    const Word head = peek();
    if (head.is_word("ELSE"))
        refuse(head, "ELSE is an option of CASE", "write TRUE in an IF");
    parse_header([&] {
        choice.condition = std::make_unique<Expression>(parse_expression());
        end_line("a condition");
    });
    choice.process = parse_body(head);
    return choice;
}

Alternation Parser::parse_alternation(bool has_priority) {
    const Word head = take();
    Alternation process;
    process.has_priority = has_priority;
    parse_header([&] {
        if (has_priority)
            expect_word("ALT", "after PRI");
        process.replicator = parse_replicator();
        end_line("ALT");
    });
    parse_block(head, [&] { process.alternatives.push_back(parse_alternative()); });
    return process;
}

Alternative Parser::parse_alternative() {
    const Nesting nesting(*this);
    Alternative alternative;
    parse_declarations(alternative.declarations, true);
    alternative.at = peek().at;
    const Word head = peek();
    if (head.is_word("ALT") || (head.is_word("PRI") && peek(1).is_word("ALT"))) {
        alternative.guard = std::make_unique<Alternation>(parse_alternation(head.is_word("PRI")));
        return alternative;
    }
    parse_header([&] { parse_guard(alternative); });
    if (!std::holds_alternative<VariantInput>(alternative.guard))
        alternative.process = parse_body(head);
    return alternative;
}

void Parser::parse_guard(Alternative& alternative) {
    const Word first = peek();
    if (first.is_word("SKIP"))
        refuse(first, "SKIP needs a condition in an ALT", "write TRUE & SKIP");
    Expression channel = parse_expression();
    if (accept("&")) {
        alternative.condition = std::make_unique<Expression>(std::move(channel));
        if (accept_word("SKIP"))
            return end_line("a guard");
        channel = parse_element("a channel");
    }
    expect("?", "in a guard of ALT");
    if (accept_word("AFTER")) {
        alternative.guard = Delay{std::move(channel), parse_expression()};
        return end_line("a guard");
    }
    if (accept_word("CASE")) {
        VariantInput input{std::move(channel), {}};
        const bool is_one_tag = peek().kind != WordKind::end;
        parse_variants(input, first);
        if (is_one_tag)
            input.variants.front().process = parse_body(first);
        alternative.guard = std::move(input);
        return;
    }
    alternative.guard = Input{std::move(channel), parse_items()};
    end_line("a guard");
}

/// Reads the variants of `c ? CASE`: several variants on the lines below, each with its process, or one variant on the
/// same line.
void Parser::parse_variants(VariantInput& input, const Word& head) {
    if (peek().kind != WordKind::end) {
        Variant variant;
        variant.at = peek().at;
        parse_tag(variant);
        input.variants.push_back(std::move(variant));
        return;
    }
    end_line("CASE");
    parse_block(head, [&] { input.variants.push_back(parse_variant()); });
}

Variant Parser::parse_variant() {
    const Nesting nesting(*this);
    Variant variant;
    parse_declarations(variant.declarations, true);
    variant.at = peek().at;
    const Word head = peek();
    parse_header([&] { parse_tag(variant); });
    variant.process = parse_body(head);
    return variant;
}

void Parser::parse_tag(Variant& variant) {
    variant.tag = expect_name("a tag");
    if (accept(";"))
        variant.items = parse_items();
    end_line("a variant");
}

} // namespace placedpar::occam
