#include "occam/language/parser.hpp"

#include "text/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace placedpar::occam {

namespace {

struct OperatorWord {
    std::string_view word;
    Operator operation;
};
constexpr std::array<OperatorWord, 25> dyadic_operators = {{{"+", Operator::add},
                                                            {"-", Operator::subtract},
                                                            {"*", Operator::multiply},
                                                            {"/", Operator::divide},
                                                            {"\\", Operator::remainder},
                                                            {"REM", Operator::remainder},
                                                            {"PLUS", Operator::plus},
                                                            {"MINUS", Operator::minus},
                                                            {"TIMES", Operator::times},
                                                            {"/\\", Operator::bit_and},
                                                            {"BITAND", Operator::bit_and},
                                                            {"\\/", Operator::bit_or},
                                                            {"BITOR", Operator::bit_or},
                                                            {"><", Operator::bit_xor},
                                                            {"<<", Operator::shift_left},
                                                            {">>", Operator::shift_right},
                                                            {"=", Operator::equal},
                                                            {"<>", Operator::unequal},
                                                            {"<", Operator::less},
                                                            {">", Operator::greater},
                                                            {"<=", Operator::less_or_equal},
                                                            {">=", Operator::greater_or_equal},
                                                            {"AFTER", Operator::after},
                                                            {"AND", Operator::logical_and},
                                                            {"OR", Operator::logical_or}}};
constexpr std::array<OperatorWord, 6> monadic_operators = {{{"-", Operator::negate},
                                                            {"MINUS", Operator::minus_modulo},
                                                            {"~", Operator::bit_not},
                                                            {"BITNOT", Operator::bit_not},
                                                            {"NOT", Operator::logical_not},
                                                            {"SIZE", Operator::size}}};

template <std::size_t N>
std::optional<Operator> operator_of(const Word& word, const std::array<OperatorWord, N>& table) {
    if (word.kind == WordKind::symbol || word.kind == WordKind::keyword)
        for (const OperatorWord& each : table)
            if (word.text == each.word)
                return each.operation;
    return std::nullopt;
}

bool is_logical(Operator operation) { return operation == Operator::logical_and || operation == Operator::logical_or; }

} // namespace

std::vector<Expression> Parser::parse_expressions() {
    std::vector<Expression> expressions;
    do
        expressions.push_back(parse_expression());
    while (accept(","));
    return expressions;
}

Expression Parser::parse_expression() {
    const Nesting nesting(*this);
    if (const auto monadic = operator_of(peek(), monadic_operators))
        return parse_unary(*monadic);
    if (is_conversion())
        return parse_conversion(parse_type());
    return parse_chain(parse_operand());
}

/// Reads the operator and the operand after the first operand. Refuses a second operator, because occam's operators
/// have no precedence; only AND and OR may be chained.
Expression Parser::parse_chain(Expression left) {
    std::size_t length = 0;
    std::optional<Operator> last;
    while (const auto operation = operator_of(peek(), dyadic_operators)) {
        const Word word = take();
        if (last && !(is_logical(*last) && is_logical(*operation)))
            refuse(word,
                   fmt::format("\"{}\" follows another operator, but occam has no precedence of operators", word.text),
                   "put parentheses around the operation that comes first: (a * b) + c");
        if (++length > deepest_nesting)
            reading_.reporter.give_up(at(word), fmt::format("at most {} operators can be chained", deepest_nesting));
        Expression right = parse_operand();
        left = made(word, BinaryOperation{*operation, std::make_unique<Expression>(std::move(left)),
                                          std::make_unique<Expression>(std::move(right))});
        last = operation;
    }
    return left;
}

Expression Parser::parse_unary(Operator operation) {
    const Word word = take();
    Expression operand = parse_operand();
    if (auto* literal = std::get_if<IntegerLiteral>(&operand.form); literal && operation == Operator::negate)
        literal->negative_allowed = true;
    if (operator_of(peek(), dyadic_operators))
        refuse(peek(),
               fmt::format("\"{}\" follows another operator, but occam has no precedence of operators", peek().text),
               fmt::format("put parentheses around the operation that comes first: ({}x) + y",
                           word.kind == WordKind::keyword ? std::string(word.text) + " " : std::string(word.text)));
    return made(word, UnaryOperation{operation, std::make_unique<Expression>(std::move(operand))});
}

/// Returns whether a conversion begins here, such as `INT x`, or `LENGTH x`, in which LENGTH is a DATA TYPE.
bool Parser::is_conversion() const {
    if (basic_type(peek()))
        return true;
    const Word& next = peek(1);
    return peek().kind == WordKind::name &&
           (next.kind == WordKind::name || next.kind == WordKind::integer || next.kind == WordKind::real ||
            next.is_word("ROUND") || next.is_word("TRUNC")) &&
           next.text != "STEP";
}

Expression Parser::parse_conversion(std::shared_ptr<TypeText> type) {
    const Word word = last_;
    Conversion conversion;
    if (accept_word("ROUND"))
        conversion.rounding = Conversion::Rounding::round;
    else if (accept_word("TRUNC"))
        conversion.rounding = Conversion::Rounding::truncate;
    conversion.operand = std::make_unique<Expression>(parse_operand());
    conversion.to = std::move(type);
    if (operator_of(peek(), dyadic_operators))
        refuse(peek(),
               fmt::format("\"{}\" follows a conversion, but occam has no precedence of operators", peek().text),
               fmt::format("put parentheses around the conversion: ({} x) + y", word.text));
    return made(word, std::move(conversion));
}

/// Reads an operand. Names, segments, tables and strings may have subscripts.
Expression Parser::parse_operand() {
    const bool is_in_parentheses = peek().is("(");
    Expression operand = parse_primary();
    const bool has_elements = !is_in_parentheses && !std::holds_alternative<Call>(operand.form);
    return has_elements ? parse_subscripts(std::move(operand)) : std::move(operand);
}

Expression Parser::parse_primary() {
    const Word& word = peek();
    switch (word.kind) {
    case WordKind::integer:
    case WordKind::real: return parse_number_literal();
    case WordKind::character: return parse_character();
    case WordKind::string: return parse_string();
    case WordKind::name: return parse_name_or_call();
    default: break;
    }
    if (word.is("["))
        return parse_brackets();
    if (word.is("("))
        return parse_parentheses();
    if (word.is_word("TRUE") || word.is_word("FALSE"))
        return parse_boolean();
    if (word.is_word("MOSTPOS") || word.is_word("MOSTNEG"))
        return parse_bound();
    const bool needs_parentheses = basic_type(word) || operator_of(word, monadic_operators);
    refuse(word, fmt::format("an operand is missing: found {}", describe(word)),
           needs_parentheses ? "put parentheses around an operation or conversion within another operation" : "");
}

void Parser::parse_literal_type(std::optional<Basic>& type, std::string& name) {
    const bool has_type = peek().is("(") && peek(2).is(")") && (basic_type(peek(1)) || peek(1).kind == WordKind::name);
    if (!has_type)
        return;
    take();
    type = basic_type(peek());
    if (!type)
        name = std::string(peek().text);
    take();
    take();
}

Expression Parser::parse_number_literal() {
    const Word word = take();
    if (word.kind == WordKind::real) {
        RealLiteral literal{.digits = std::string(word.text), .type = {}};
        parse_literal_type(literal.type, literal.type_name);
        return made(word, std::move(literal));
    }
    IntegerLiteral literal;
    const bool is_hexadecimal = word.text.starts_with('#');
    const auto value = is_hexadecimal ? parse_number<std::uint64_t>(word.text.substr(1), 16)
                                      : parse_number<std::uint64_t>(word.text, 10);
    if (!value)
        reading_.reporter.error(at(word), fmt::format("the number {} has more than 64 bits", word.text));
    literal.value = value.value_or(0);
    parse_literal_type(literal.type, literal.type_name);
    return made(word, std::move(literal));
}

Expression Parser::parse_boolean() {
    const Word word = take();
    return made(word, IntegerLiteral{.value = word.text == "TRUE" ? 1u : 0u, .type = Basic::boolean});
}

Expression Parser::parse_character() {
    const Word word = take();
    IntegerLiteral literal{.value = static_cast<unsigned char>(word.bytes.front()), .type = Basic::byte};
    parse_literal_type(literal.type, literal.type_name);
    return made(word, std::move(literal));
}

Expression Parser::parse_string() {
    const Word word = take();
    std::string bytes = word.bytes;
    if (word.text.starts_with("\"*l") || word.text.starts_with("\"*L")) {
        if (bytes.size() > 256)
            refuse(word, fmt::format("a string that begins with its length has at most 255 bytes; this one has {}",
                                     bytes.size() - 1));
        bytes.front() = static_cast<char>(bytes.size() - 1);
    }
    return made(word, StringLiteral{std::move(bytes)});
}

Expression Parser::parse_bound() {
    const Word word = take();
    const bool is_positive = word.text == "MOSTPOS";
    return made(
        word, TypeBound{is_positive ? TypeBound::Which::most_positive : TypeBound::Which::most_negative, parse_type()});
}

Expression Parser::parse_name_or_call() {
    const Word word = peek();
    static constexpr std::array<std::string_view, 3> foreign = {"MOBILE", "CLONE", "NOW"};
    const bool is_operator = peek(1).kind == WordKind::name || peek(1).is("[");
    if (is_operator && std::ranges::find(foreign, word.text) != foreign.end())
        refuse_unread(word, "an operand");
    take();
    if (!accept("("))
        return made(word, NameUse{std::string(word.text)});
    if (word.text == "BYTESIN" && type_length(0) != 0 && peek(type_length(0)).is(")")) {
        TypeBound bound{TypeBound::Which::bytes_in, parse_type()};
        take();
        return made(word, std::move(bound));
    }
    if (word.text == "OFFSETOF") {
        OffsetOf offset{parse_type(), ""};
        expect(",", "between the type and the field of OFFSETOF");
        offset.field = expect_name("a field");
        expect(")", "after OFFSETOF");
        return made(word, std::move(offset));
    }
    Call call{std::string(word.text), parse_arguments()};
    return made(word, std::move(call));
}

/// Reads arguments and the `)` after them.
std::vector<Expression> Parser::parse_arguments() {
    std::vector<Expression> arguments;
    if (accept(")"))
        return arguments;
    do
        arguments.push_back(parse_argument());
    while (accept(","));
    if (!accept(")"))
        refuse(peek(), fmt::format("\",\" or \")\" is expected after an argument: found {}", describe(peek())));
    return arguments;
}

Expression Parser::parse_argument() {
    Expression argument = parse_expression();
    accept_direction(argument.written_output);
    return argument;
}

bool Parser::accept_direction(std::optional<bool>& is_output) {
    if (!peek().is("!") && !peek().is("?"))
        return false;
    is_output = take().text == "!";
    return true;
}

Expression Parser::parse_subscripts(Expression array) {
    std::size_t depth = 0;
    while (peek().is("[")) {
        const Word word = take();
        if (++depth > deepest_nesting)
            reading_.reporter.give_up(at(word), fmt::format("at most {} subscripts are allowed", deepest_nesting));
        Subscript subscript;
        const Place start = array.at;
        subscript.array = std::make_unique<Expression>(std::move(array));
        subscript.index = std::make_unique<Expression>(parse_expression());
        expect("]", "after a subscript");
        array = made(word, std::move(subscript));
        array.at = start;
    }
    return array;
}

/// Reads a table or a segment.
Expression Parser::parse_brackets() {
    const Word word = take();
    if (peek().is("]"))
        refuse(peek(), "a table must have at least one element");
    Expression first = parse_expression();
    if (peek().is_word("FROM") || peek().is_word("FOR")) {
        Segment segment;
        segment.array = std::make_unique<Expression>(std::move(first));
        if (accept_word("FROM"))
            segment.from = std::make_unique<Expression>(parse_expression());
        if (accept_word("FOR"))
            segment.count = std::make_unique<Expression>(parse_expression());
        expect("]", "after a segment");
        return made(word, std::move(segment));
    }
    TableLiteral table;
    table.elements.push_back(std::move(first));
    while (accept(","))
        table.elements.push_back(parse_expression());
    if (!accept("]"))
        refuse(peek(), fmt::format("\",\" or \"]\" is expected in a table: found {}", describe(peek())));
    if (peek().is("(")) {
        take();
        table.type = parse_type();
        expect(")", "after the type of a table");
    }
    return made(word, std::move(table));
}

/// Returns whether declarations or VALOF follow the `(` before this word.
bool Parser::is_value_process() const {
    if (peek().is_word("VALOF"))
        return true;
    return is_declaration(true) && peek().kind != WordKind::directive;
}

Expression Parser::parse_parentheses() {
    const Word word = take();
    if (is_value_process()) {
        ValueProcess value = parse_value_process();
        expect(")", "after the RESULT of a VALOF");
        return made(word, std::move(value));
    }
    Expression inner = parse_expression();
    if (!accept(")"))
        refuse(peek(), fmt::format("\")\" is missing: found {}", describe(peek())));
    return inner;
}

/// Reads declarations, VALOF, its process and its results. A `)` may follow the results.
ValueProcess Parser::parse_value_process() {
    ValueProcess value;
    parse_declarations(value.declarations, true);
    const Word head = peek();
    expect_word("VALOF", "after the declarations of a value");
    end_line("VALOF");
    parse_value_body(value, head);
    return value;
}

void Parser::parse_value_body(ValueProcess& value, const Word& head) {
    bool has_results = false;
    parse_block(head, [&] {
        const Word first = peek();
        if (accept_word("RESULT")) {
            has_results = true;
            value.results_at = first.at;
            value.results = parse_expressions();
            if (!peek().is(")"))
                end_line("the results");
        } else {
            Process process = parse_process();
            if (value.process)
                refuse(first, "only one process is allowed in a VALOF", "put SEQ above both");
            value.process = std::make_unique<Process>(std::move(process));
        }
    });
    if (!has_results)
        refuse(head, "RESULT is missing in this VALOF");
    if (!value.process)
        value.process = std::make_unique<Process>(Process{head.at, Skip{}});
}

} // namespace placedpar::occam
