#include "tests/occam/language/printer.hpp"

#include <fmt/format.h>

#include <array>

namespace placedpar::occam {

namespace {

std::string name_of_operator(Operator operation) {
    static constexpr std::array<const char*, 27> names = {
        "+",  "-", "*", "/",  "\\", "PLUS",  "MINUS", "TIMES", "/\\", "\\/",   "><", "<<",  ">>",  "=",
        "<>", "<", ">", "<=", ">=", "AFTER", "AND",   "OR",    "-",   "MINUS", "~",  "NOT", "SIZE"};
    return names[static_cast<std::size_t>(operation)];
}

std::string escaped_byte(char c, char quote) {
    switch (c) {
    case '\r': return "*c";
    case '\n': return "*n";
    case '\t': return "*t";
    case '*': return "**";
    default: break;
    }
    if (c == quote)
        return std::string("*") + c;
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte >= 0x7f ? fmt::format("*#{:02X}", unsigned{byte}) : std::string(1, c);
}

std::string literal_type(const std::optional<Basic>& type, const std::string& name) {
    if (!name.empty())
        return "(" + name + ")";
    return type ? "(" + name_of(*type) + ")" : "";
}

std::string text_of(const IntegerLiteral& literal) {
    if (literal.type == Basic::boolean)
        return literal.value == 1 ? "TRUE" : "FALSE";
    if (literal.type == Basic::byte && literal.value < 0x80)
        return "'" + escaped_byte(static_cast<char>(literal.value), '\'') + "'" +
               literal_type(std::nullopt, literal.type_name);
    return std::to_string(literal.value) + literal_type(literal.type, literal.type_name);
}

std::string text_of(const StringLiteral& literal) {
    std::string text = "\"";
    for (const char c : literal.bytes)
        text += escaped_byte(c, '"');
    return text + "\"";
}

} // namespace

std::string Printer::list(const std::vector<Expression>& expressions) {
    std::string text;
    for (const Expression& each : expressions)
        text += (text.empty() ? "" : ", ") + expression(each);
    return text;
}

/// An operand of another operation needs parentheses if it is an operation itself.
std::string Printer::operand(const Expression& expression_) {
    const bool is_operation = std::holds_alternative<UnaryOperation>(expression_.form) ||
                              std::holds_alternative<BinaryOperation>(expression_.form) ||
                              std::holds_alternative<Conversion>(expression_.form);
    return is_operation ? "(" + expression(expression_) + ")" : expression(expression_);
}

std::string Printer::expression(const Expression& each) {
    std::string text = std::visit([this](const auto& form) { return written(form); }, each.form);
    return text + (each.written_output ? *each.written_output ? "!" : "?" : "");
}

std::string Printer::written(const NameUse& use) { return use.name; }
std::string Printer::written(const IntegerLiteral& literal) { return text_of(literal); }
std::string Printer::written(const RealLiteral& literal) {
    return literal.digits + literal_type(literal.type, literal.type_name);
}
std::string Printer::written(const StringLiteral& literal) { return text_of(literal); }
std::string Printer::written(const TableLiteral& table) {
    return "[" + list(table.elements) + "]" + (table.type ? "(" + type(*table.type) + ")" : "");
}
std::string Printer::written(const UnaryOperation& unary) {
    return name_of_operator(unary.operation) + " " + operand(*unary.operand);
}

/// AND and OR stand in a chain, from left to right.
std::string Printer::written(const BinaryOperation& binary) {
    const auto is_logical = [](Operator each) { return each == Operator::logical_and || each == Operator::logical_or; };
    const auto* left = std::get_if<BinaryOperation>(&binary.left->form);
    const bool is_chain = left && is_logical(left->operation) && is_logical(binary.operation);
    return (is_chain ? expression(*binary.left) : operand(*binary.left)) + " " + name_of_operator(binary.operation) +
           " " + operand(*binary.right);
}

std::string Printer::written(const Conversion& conversion) {
    static constexpr std::array<const char*, 3> roundings = {" ", " ROUND ", " TRUNC "};
    return type(*conversion.to) + roundings[static_cast<std::size_t>(conversion.rounding)] +
           operand(*conversion.operand);
}
std::string Printer::written(const Subscript& subscript) {
    return expression(*subscript.array) + "[" + expression(*subscript.index) + "]";
}
std::string Printer::written(const Segment& segment) {
    return "[" + expression(*segment.array) + (segment.from ? " FROM " + expression(*segment.from) : "") +
           (segment.count ? " FOR " + expression(*segment.count) : "") + "]";
}
std::string Printer::written(const Call& call) { return call.name + " (" + list(call.arguments) + ")"; }

/// A value process has lines of its own. They are marked, since their indentation depends on where the first begins.
std::string Printer::written(const ValueProcess& value) {
    Printer inner(program_);
    inner.value_process(value);
    return std::string("(") + lines_begin + inner.text_ + lines_end + ")";
}
std::string Printer::written(const TypeBound& bound) {
    if (bound.which == TypeBound::Which::bytes_in)
        return "BYTESIN (" + type(*bound.of) + ")";
    return (bound.which == TypeBound::Which::most_positive ? "MOSTPOS " : "MOSTNEG ") + type(*bound.of);
}
std::string Printer::written(const OffsetOf& offset) {
    return "OFFSETOF (" + type(*offset.of) + ", " + offset.field + ")";
}

std::string Printer::item(const ItemText& each) {
    return (each.count ? type(*each.count) + "::" : "") + type(*each.type);
}

std::string Printer::protocol(const ProtocolText& protocol) {
    std::string text = protocol.any ? "ANY" : "";
    for (const ItemText& each : protocol.items)
        text += (text.empty() ? "" : "; ") + item(each);
    return text;
}

std::string Printer::type(const TypeText& type_text) {
    std::string text;
    for (const ExpressionBox& dimension : type_text.dimensions)
        text += "[" + (dimension ? expression(*dimension) : "") + "]";
    if (const auto* basic = std::get_if<Basic>(&type_text.form))
        return text + name_of(*basic);
    if (const auto* channel = std::get_if<TypeText::Channel>(&type_text.form))
        return text + "CHAN OF " + protocol(channel->protocol);
    if (const auto* port = std::get_if<TypeText::Port>(&type_text.form))
        return text + "PORT OF " + type(*port->of);
    if (const auto* named = std::get_if<TypeText::Named>(&type_text.form))
        return text + named->name;
    return text + "TIMER";
}

} // namespace placedpar::occam
