#include "occam/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar::occam {

bool Parser::is_declaration(bool or_expression) const {
    const Word& first = peek();
    static constexpr std::array<std::string_view, 9> words = {"VAL",  "PROC", "PROTOCOL", "PLACE",   "TIMER",
                                                              "CHAN", "PORT", "INLINE",   "FUNCTION"};
    if (first.kind == WordKind::directive)
        return true;
    if (is_wiring()) // `MAP p, q ONTO n` looks like a declaration of variables of the type MAP
        return false;
    if (first.kind == WordKind::keyword && std::ranges::find(words, first.text) != words.end())
        return true;
    if (first.is_word("DATA") && peek(1).is_word("TYPE"))
        return true;
    if ((first.is_word("INITIAL") && type_length(1) != 0) || is_recursive_procedure())
        return true;
    if (first.kind == WordKind::name &&
        (peek(1).is_word("IS") || ((peek(1).is("!") || peek(1).is("?")) && peek(2).is_word("IS"))))
        return true;
    const std::size_t type = type_length(0);
    if (type == 0)
        return first.is("[") && bracket_length(0) != 0 && peek(bracket_length(0)).is_word("IS");
    const Word& next = peek(type);
    if (next.is(",") || next.is_word("FUNCTION") || next.is_word("INLINE")) {
        std::size_t length = type;
        while (peek(length).is(",") && type_length(length + 1) != 0)
            length += 1 + type_length(length + 1);
        return peek(length).is_word("FUNCTION") || peek(length).is_word("INLINE");
    }
    const Word& behind = peek(type + 1);
    const bool defines = behind.is(":") || behind.is(",") || behind.is_word("IS") || behind.is_word("RETYPES") ||
                         behind.is_word("RESHAPES") || behind.is("?") || behind.is("!") ||
                         is_array_by_mistake(type + 1);
    if (first.kind == WordKind::name || or_expression)
        return next.kind == WordKind::name && defines;
    return first.kind == WordKind::keyword || next.kind == WordKind::name || next.kind == WordKind::keyword;
}

/// Returns whether the words ahead are a size and the end of a declaration, as in the wrong declaration `INT a[8]:`.
bool Parser::is_array_by_mistake(std::size_t ahead) const {
    const std::size_t length = peek(ahead).is("[") ? bracket_length(ahead) : 0;
    return length != 0 && (peek(ahead + length).is(":") || peek(ahead + length).is(","));
}

/// Returns a hint if the size of an array follows the name in a declaration; "" otherwise.
std::string Parser::hint_for_array(const std::string& type, const Word& name) const {
    return is_array_by_mistake(0)
               ? fmt::format("write the size of an array in front of its type: {}{} {}:", written(bracket_length(0)),
                             type, name.text)
               : "";
}

/// Returns a hint if a value follows the name in a declaration, as in other languages; "" otherwise.
std::string Parser::hint_for_value(const std::string& type, const Word& name) const {
    return peek().text == "=" || peek().text == ":="
               ? fmt::format(
                     "write INITIAL {0} {1} IS ...: for a variable with a first value, or VAL {0} {1} IS ...: for a "
                     "constant",
                     type, name.text)
               : "";
}

/// Returns the text of the next words, with single blanks between names, numbers and keywords.
std::string Parser::written(std::size_t words) const {
    std::string text;
    for (std::size_t i = 0; i < words; ++i) {
        const bool joins = i == 0 || peek(i).kind == WordKind::symbol || peek(i - 1).kind == WordKind::symbol;
        text += (joins ? "" : " ") + std::string(peek(i).text);
    }
    return text;
}

/// Returns whether a declaration or process of another language begins here, such as `BARRIER b:`.
bool Parser::is_foreign_statement() const {
    static constexpr std::array<std::string_view, 16> words = {
        "GUY", "MOBILE",    "SHARED", "CLAIM", "FORK", "FORKING", "BARRIER", "SYNC",
        "REC", "RECURSIVE", "ASM",    "VAR",   "DEF",  "NOW",     "WAIT",    "EXTERNAL"};
    const Word& next = peek(1);
    const bool is_variable = next.kind == WordKind::symbol && !(next.is("[") && peek(2).is("]"));
    return peek().kind == WordKind::name && !is_variable && std::ranges::find(words, peek().text) != words.end();
}

void Parser::parse_declarations(std::vector<DeclarationBox>& declarations, bool or_expression) {
    const std::uint32_t indentation = peek().indentation;
    while (!is_at_end() && is_declaration(or_expression)) {
        const Word first = peek();
        const std::size_t line = lines_taken_;
        if (first.indentation < indentation)
            return;
        if (first.indentation > indentation && !std::exchange(indentation_in_doubt_, true))
            reading_.reporter.error(at(first), "this declaration is indented further than the declaration above");
        try {
            parse_with_start(declarations);
        } catch (const LineRefused&) {
            recover(first.indentation, line);
        }
    }
}

/// Reads declarations such as `INT a, b:`, and notes where they begin.
void Parser::parse_with_start(std::vector<DeclarationBox>& declarations) {
    const Place start = peek().at;
    std::size_t next = declarations.size();
    parse_declaration(declarations);
    for (; next < declarations.size(); ++next)
        declarations[next]->start = start;
}

void Parser::parse_declaration(std::vector<DeclarationBox>& declarations) {
    const Nesting nesting(*this);
    const Word& first = peek();
    if (first.kind == WordKind::directive)
        return parse_use(declarations);
    if (first.is_word("VAL"))
        return parse_value(declarations);
    if (first.is_word("PROC") || (first.is_word("INLINE") && peek(1).is_word("PROC")) || is_recursive_procedure())
        return parse_procedure(declarations);
    if (first.is_word("PROTOCOL"))
        return parse_protocol(declarations);
    if (first.is_word("PLACE"))
        return parse_placement(declarations);
    if (first.is_word("DATA") && peek(1).is_word("TYPE"))
        return parse_data_type(declarations);
    if (first.is_word("INITIAL") && type_length(1) != 0)
        return parse_initial(declarations);
    const std::size_t type = type_length(0);
    if (type != 0 && (peek(type).is_word("FUNCTION") || peek(type).is_word("INLINE") || peek(type).is(",")))
        return parse_function(declarations);
    const bool has_type = type != 0 && !peek(1).is_word("IS") && !peek(2).is_word("IS");
    if (has_type || first.kind == WordKind::keyword || (first.is("[") && type != 0))
        return parse_typed(declarations);
    parse_untyped(declarations, false);
}

DeclarationBox& Parser::add(std::vector<DeclarationBox>& declarations, const Word& name,
                            decltype(Declaration::form) form) {
    auto declaration = std::make_unique<Declaration>();
    declaration->at = name.at;
    declaration->name = std::string(name.text);
    declaration->form = std::move(form);
    return declarations.emplace_back(std::move(declaration));
}

/// Expects the `:` that ends a declaration, and continues with the next line.
void Parser::end_declaration(std::string_view what, const std::string& hint) {
    if (!accept(":")) {
        if (peek().kind != WordKind::end)
            refuse(peek(), fmt::format("\":\" is expected after {}: found {}", what, describe(peek())), hint);
        reading_.reporter.error(at(peek()), fmt::format("\":\" is missing after {}", what));
    }
    end_line("\":\"");
}

void Parser::parse_use(std::vector<DeclarationBox>& declarations) {
    const Word word = take();
    const Word name = take();
    const auto found = find_file(reading_, name.bytes, FileUse::use, name.at);
    if (found && !reading_.units.contains(found->key) && found->file) {
        const auto index = add_file(reading_, found->file, at(word));
        reading_.open.push_back({found->key, at(word)});
        auto unit = std::make_unique<Unit>();
        unit->name = name.bytes;
        unit->file = index;
        unit->declarations = Parser(reading_, index).parse_file();
        reading_.open.pop_back();
        reading_.units[found->key] = reading_.program.units.size();
        reading_.program.units.push_back(std::move(unit));
    }
    if (found && reading_.units.contains(found->key)) {
        Word shown = name;
        shown.text = {};
        add(declarations, shown, Use{reading_.units[found->key]})->name = name.bytes;
    }
    end_line("#USE");
}

/// Reads `VAL x IS e:`, `VAL T x IS e:` and RETYPES.
void Parser::parse_value(std::vector<DeclarationBox>& declarations) {
    take();
    if (peek(1).is_word("IS") || (peek().kind == WordKind::keyword && !basic_type(peek()) && !peek().is_word("CHAN")))
        return parse_untyped(declarations, true);
    auto type = parse_type();
    const Word name = peek();
    expect_name("a value");
    if (!parse_definition(declarations, name, std::move(type), true))
        refuse(peek(), fmt::format("IS or RETYPES is expected: found {}", describe(peek())));
}

/// Reads `x IS e:` or `c! IS d!:`.
void Parser::parse_untyped(std::vector<DeclarationBox>& declarations, bool is_value) {
    const Word name = peek();
    expect_name(is_value ? "a value" : "an abbreviation");
    Abbreviation abbreviation;
    abbreviation.is_value = is_value;
    accept_direction(abbreviation.written_output);
    expect_word("IS", "in an abbreviation");
    abbreviation.value = parse_argument();
    add(declarations, name, std::move(abbreviation));
    end_declaration("an abbreviation");
}

/// Reads the part after `T x` in `T x IS e:` and `T x RETYPES e:`. Returns false if neither IS nor RETYPES follows.
bool Parser::parse_definition(std::vector<DeclarationBox>& declarations, const Word& name,
                              std::shared_ptr<TypeText> type, bool is_value) {
    std::optional<bool> is_output;
    if ((peek().is("!") || peek().is("?")) && peek(1).is_word("IS"))
        accept_direction(is_output);
    if (accept_word("IS")) {
        Abbreviation abbreviation{
            .is_value = is_value, .type = std::move(type), .value = parse_argument(), .written_output = is_output};
        add(declarations, name, std::move(abbreviation));
        end_declaration("an abbreviation");
        return true;
    }
    if (!peek().is_word("RETYPES") && !peek().is_word("RESHAPES"))
        return false;
    Retyping retyping{
        .is_value = is_value, .reshapes = take().text == "RESHAPES", .type = std::move(type), .value = {}};
    retyping.value = parse_expression();
    add(declarations, name, std::move(retyping));
    end_declaration("RETYPES");
    return true;
}

/// Reads variables, abbreviations and retypings that begin with a type.
void Parser::parse_typed(std::vector<DeclarationBox>& declarations) {
    const std::string type_text = written(type_length(0));
    auto type = parse_type();
    Word name = peek();
    expect_name("a variable");
    if (parse_definition(declarations, name, type, false))
        return;
    add(declarations, name, Variable{.type = type, .initial = nullptr});
    while (accept(",")) {
        name = peek();
        expect_name("a variable");
        add(declarations, name, Variable{.type = type, .initial = nullptr});
    }
    const std::string hint = hint_for_value(type_text, name);
    end_declaration("a declaration", hint.empty() ? hint_for_array(type_text, name) : hint);
}

void Parser::parse_initial(std::vector<DeclarationBox>& declarations) {
    take();
    auto type = parse_type();
    const Word name = peek();
    expect_name("a variable");
    expect_word("IS", "after a variable with INITIAL");
    auto value = std::make_unique<Expression>(parse_expression());
    add(declarations, name, Variable{.type = std::move(type), .initial = std::move(value)});
    end_declaration("a declaration");
}

void Parser::parse_placement(std::vector<DeclarationBox>& declarations) {
    take();
    const Word name = peek();
    Placement placement;
    do {
        const Word first = peek();
        NameUse use{expect_name("a variable or channel")};
        placement.paths.push_back(parse_subscripts(made(first, std::move(use))));
    } while (accept(","));
    if (accept_word("AT"))
        placement.address = std::make_unique<Expression>(parse_expression());
    else if (accept_word("ON")) {
        placement.where = Placement::Where::arc;
        placement.address = std::make_unique<Expression>(parse_element("an arc"));
    } else {
        if (!accept_word("IN"))
            refuse(peek(), fmt::format("AT or IN is expected after the name: found {}", describe(peek())));
        placement.where = peek().is_word("WORKSPACE") ? Placement::Where::workspace : Placement::Where::vector_space;
        if (!accept_word("WORKSPACE"))
            expect_word("VECSPACE", "after IN (WORKSPACE is also possible)");
    }
    add(declarations, name, std::move(placement));
    end_declaration("a placement");
}

void Parser::parse_protocol(std::vector<DeclarationBox>& declarations) {
    const Word head = take();
    const Word name = peek();
    expect_name("a protocol");
    Protocol protocol;
    if (accept_word("IS")) {
        protocol.items = parse_sequence();
        add(declarations, name, std::move(protocol));
        return end_declaration("a protocol");
    }
    protocol.is_variant = true;
    if (peek().kind != WordKind::end && !peek().is_word("CASE"))
        refuse(peek(), fmt::format("IS or CASE is expected after the name of a protocol: found {}", describe(peek())));
    if (accept_word("CASE")) {
        end_line("CASE");
        parse_tags(protocol, head);
    } else {
        end_line("the name of a protocol without IS");
        parse_block(head, [&] {
            const Word below = peek();
            expect_word("CASE", "below the name of a protocol without IS");
            end_line("CASE");
            parse_tags(protocol, below);
        });
    }
    add(declarations, name, std::move(protocol));
    end_body(head, fmt::format("PROTOCOL {}", name.text));
}

void Parser::parse_tags(Protocol& protocol, const Word& head) {
    parse_block(head, [&] {
        TagText tag;
        tag.at = peek().at;
        tag.name = expect_name("a tag");
        if (accept(";"))
            tag.items = parse_sequence().items;
        end_line("a tag");
        protocol.tags.push_back(std::move(tag));
    });
}

void Parser::parse_data_type(std::vector<DeclarationBox>& declarations) {
    const Word head = take();
    take();
    const Word name = peek();
    expect_name("a data type");
    DataType type;
    if (accept_word("IS")) {
        type.is = parse_type();
        add(declarations, name, std::move(type));
        return end_declaration("a data type");
    }
    end_line("the name of a data type");
    parse_record(type, head);
    add(declarations, name, std::move(type));
    end_body(head, fmt::format("DATA TYPE {}", name.text));
}

void Parser::parse_record(DataType& type, const Word& head) {
    parse_block(head, [&] {
        const Word record = peek();
        type.is_packed |= accept_word("PACKED");
        expect_word("RECORD", "in a data type");
        end_line("RECORD");
        parse_fields(type, record);
    });
    if (type.fields.empty() && !reading_.reporter.failed())
        reading_.reporter.error(at(head), "a RECORD must have at least one field");
}

void Parser::parse_fields(DataType& type, const Word& head) {
    parse_block(head, [&] {
        const std::string type_text = written(type_length(0));
        const auto field_type = parse_type();
        Word name;
        do {
            name = peek();
            type.fields.push_back({name.at, expect_name("a field"), field_type});
        } while (accept(","));
        end_declaration("a field", hint_for_array(type_text, name));
    });
}

} // namespace placedpar::occam
