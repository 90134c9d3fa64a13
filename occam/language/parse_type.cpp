#include "occam/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar::occam {

std::optional<Basic> Parser::basic_type(const Word& word) const {
    static constexpr std::array all = {Basic::boolean, Basic::byte,  Basic::integer, Basic::int16,
                                       Basic::int32,   Basic::int64, Basic::real32,  Basic::real64};
    if (word.kind == WordKind::keyword)
        for (const Basic each : all)
            if (word.text == name_of(each))
                return each;
    return std::nullopt;
}

std::shared_ptr<TypeText> Parser::parse_type() {
    const Nesting nesting(*this);
    auto type = std::make_shared<TypeText>();
    type->at = peek().at;
    while (accept("["))
        if (accept("]"))
            type->dimensions.push_back(nullptr);
        else {
            type->dimensions.push_back(std::make_unique<Expression>(parse_expression()));
            expect("]", "after the size of an array");
        }
    parse_base_type(*type);
    return type;
}

void Parser::parse_base_type(TypeText& type) {
    const Word& word = peek();
    if (const auto basic = basic_type(word)) {
        take();
        type.form = *basic;
    } else if (accept_word("TIMER"))
        type.form = TypeText::Timer{};
    else if (accept_word("CHAN"))
        type.form = TypeText::Channel{parse_channel_protocol()};
    else if (accept_word("PORT")) {
        expect_word("OF", "after PORT");
        type.form = TypeText::Port{parse_type()};
    } else {
        refuse_foreign_type();
        if (word.kind != WordKind::name)
            refuse(word, fmt::format("a type is expected: found {}", describe(word)));
        type.form = TypeText::Named{std::string(take().text)};
    }
}

/// Refuses words of other languages that stand where a type is expected.
void Parser::refuse_foreign_type() {
    static constexpr std::array<std::string_view, 5> words = {"MOBILE", "SHARED", "BARRIER", "VAR", "VALUE"};
    const bool is_foreign = std::ranges::find(words, peek().text) != words.end();
    const bool stands_before_type =
        peek(1).kind == WordKind::name || peek(1).kind == WordKind::keyword || peek(1).is("[");
    if (is_foreign && stands_before_type)
        refuse_unread(peek(), "a type");
}

ProtocolText Parser::parse_channel_protocol() {
    const bool has_of = accept_word("OF");
    ProtocolText protocol;
    const Word& word = peek();
    if (!has_of && word.kind == WordKind::name && (peek(1).is(":") || peek(1).is(",") || peek(1).is(")")))
        refuse(word, "the protocol of the channel is missing: only occam 1 has channels without a protocol",
               "write CHAN OF INT " + std::string(word.text));
    if (accept_word("ANY"))
        protocol.any = true;
    else
        protocol.items.push_back(parse_item_type());
    return protocol;
}

ItemText Parser::parse_item_type() {
    ItemText item;
    item.type = parse_type();
    if (accept("::")) {
        item.count = std::move(item.type);
        item.type = parse_type();
    }
    return item;
}

ProtocolText Parser::parse_sequence() {
    ProtocolText protocol;
    if (accept_word("ANY"))
        protocol.any = true;
    else
        do
            protocol.items.push_back(parse_item_type());
        while (accept(";"));
    return protocol;
}

/// Returns the number of words from a bracket to its closing bracket; 0 if the line has no closing bracket.
std::size_t Parser::bracket_length(std::size_t ahead) const {
    std::size_t depth = 0;
    for (std::size_t i = ahead; peek(i).kind != WordKind::end; ++i) {
        if (peek(i).is("[") || peek(i).is("("))
            ++depth;
        if ((peek(i).is("]") || peek(i).is(")")) && --depth == 0)
            return i - ahead + 1;
    }
    return 0;
}

/// Returns the number of words of dimensions such as `[4][]`; 0 if there are none, or if this is a segment or a table.
std::size_t Parser::dimensions_length(std::size_t ahead) const {
    std::size_t length = 0;
    while (peek(ahead + length).is("[")) {
        const std::size_t one = bracket_length(ahead + length);
        std::size_t depth = 0;
        for (std::size_t i = ahead + length; i < ahead + length + one; ++i) {
            depth += peek(i).is("[") || peek(i).is("(") ? 1 : 0;
            depth -= peek(i).is("]") || peek(i).is(")") ? 1 : 0;
            if (depth == 1 && (peek(i).is_word("FROM") || peek(i).is_word("FOR") || peek(i).is(",")))
                return 0;
        }
        if (one == 0)
            return 0;
        length += one;
    }
    return length;
}

std::size_t Parser::type_length(std::size_t ahead) const {
    const std::size_t dimensions = dimensions_length(ahead);
    const Word& base = peek(ahead + dimensions);
    std::size_t length = dimensions + 1;
    if (basic_type(base) || base.is_word("TIMER"))
        return length;
    if (base.is_word("PORT")) {
        length += peek(ahead + length).is_word("OF") ? 1 : 0;
        return length + type_length(ahead + length);
    }
    if (base.kind == WordKind::name)
        return length;
    if (!base.is_word("CHAN"))
        return 0;
    length += peek(ahead + length).is_word("OF") ? 1 : 0;
    if (peek(ahead + length).is_word("ANY"))
        return length + 1;
    length += type_length(ahead + length);
    return peek(ahead + length).is("::") ? length + 1 + type_length(ahead + length + 1) : length;
}

} // namespace placedpar::occam
