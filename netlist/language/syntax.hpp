#pragma once

#include "netlist/language/token.hpp"
#include "netlist/network/direction.hpp"
#include "text/diagnostic.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace placedpar {

/// These structures form the syntax tree of a netlist, before its names are resolved.

struct Expression;
using ExpressionPointer = std::unique_ptr<Expression>;

struct IntegerLiteral {
    Integer value;
};
struct RealLiteral {
    double value;
};
struct TextLiteral {
    std::string value;
};
struct NameUse {
    std::string name;
};
struct UnaryOperation {
    std::string symbol; ///< - + ! ~
    ExpressionPointer operand;
};
struct BinaryOperation {
    std::string symbol;
    ExpressionPointer left, right;
};
/// Holds an expression `condition ? then : otherwise`.
struct ConditionalOperation {
    ExpressionPointer condition, then, otherwise;
};
struct CastOperation {
    std::string type; ///< char short int long float double
    ExpressionPointer operand;
};
struct SubscriptOperation {
    ExpressionPointer array, subscript;
};
/// Holds an expression `size(array)`.
struct SizeOperation {
    ExpressionPointer array;
};
struct ArrayConstant {
    std::vector<ExpressionPointer> elements;
};

struct Expression {
    Location at; ///< location; an operation with two or three operands is located at its operator
    std::variant<IntegerLiteral, RealLiteral, TextLiteral, NameUse, UnaryOperation, BinaryOperation,
                 ConditionalOperation, CastOperation, SubscriptOperation, SizeOperation, ArrayConstant>
        form;
    int height = 1; ///< height of the tree, limited so that walking it cannot exhaust the stack
};

/// Names a declared thing or a part of a thing, such as `name[1][2].field[3]`.
struct Reference {
    Location at;
    std::string name;
    std::vector<ExpressionPointer> subscripts;
    std::string field; ///< the name after the dot; "" if the text has no dot
    Location field_at;
    std::vector<ExpressionPointer> field_subscripts;
};

/// Holds an attribute `name = value`, or `name (a = 1, b = 2)` with a group in place of the value.
struct Attribute {
    std::string name;
    Location at;
    ExpressionPointer value; ///< null for a group
    std::vector<Attribute> group;
};

/// Holds a name and dimensions in a declaration, such as `name[2][3]`.
struct Declarator {
    std::string name;
    Location at;
    std::vector<ExpressionPointer> dimensions;
};

/// Holds a channel's direction, or a parameter's type such as "int".
using EntryType = std::variant<Direction, std::string>;

/// Holds one entry of `interface (...)`: a channel end or a parameter.
struct InterfaceEntry {
    EntryType type;
    Declarator declarator;
    ExpressionPointer default_value; ///< null if no default is given, and for channels
};

/// Holds the contents of the parentheses of a declaration. Only processes have an interface.
struct DeclarationAttributes {
    std::vector<Attribute> attributes;
    std::optional<std::vector<InterfaceEntry>> interface;
    Location interface_at;
};

struct Statement;
using Statements = std::vector<Statement>;

struct ValStatement {
    std::string name;
    ExpressionPointer value;
};
struct DefineStatement {
    std::string base;
    Location base_at;
    DeclarationAttributes attributes;
    std::vector<Declarator> names; ///< without dimensions
};
/// Declares nodes or processes, depending on the type. `process (...);` without names sets the defaults for the
/// processes that follow.
struct Declaration {
    std::string type;
    Location type_at;
    DeclarationAttributes attributes;
    std::vector<Declarator> names;
};
struct ConnectionDeclaration {
    std::vector<Attribute> attributes;
    std::vector<Declarator> names;
};
struct EdgeChannelDeclaration {
    Direction direction;
    std::vector<Declarator> names;
};
/// Holds a statement such as `name (n = 4);`. It sets parameters of a process, or attributes of a connection or of a
/// process type.
struct ParameterSetting {
    Reference process;
    std::vector<Attribute> values;
};
/// Holds an option such as `n = 4` or `p[1].n = 4`. It sets a val, or an attribute or a parameter of a declared
/// element.
struct SetStatement {
    Reference target;
    ExpressionPointer value; ///< null if the text is not an expression, such as a string without quotes
    std::string typed;       ///< the text of the value
    Location value_at;
    std::vector<Diagnostic> problems; ///< why the text is not an expression
    std::size_t place = 0;            ///< position among the options

    /// Returns how precise the target is: 0 for a member of every element, 1 for a member of a named element or array,
    /// and one more for each subscript.
    std::size_t precision() const { return target.field.empty() ? 0 : 1 + target.subscripts.size(); }
};
struct ConnectStatement {
    Reference a, b;
    std::optional<Reference> by;
};
struct UseStatement {
    ExpressionPointer program;
    std::optional<Reference> process; ///< empty: the program is the default of all processes
};
struct PlaceStatement {
    Reference what, where;
};
/// Holds a statement such as `fault t[0].link[1] silent (from = 20ms);`.
struct FaultStatement {
    Reference what;
    std::string fault;
    Location fault_at;
    std::vector<Attribute> attributes;
};
struct RepStatement {
    std::string name;
    Location name_at;
    ExpressionPointer first, count, last; ///< `for count` or `to last`; count or last is null
    std::unique_ptr<Statement> body;
};
struct IfStatement {
    ExpressionPointer condition;
    std::unique_ptr<Statement> then, otherwise; ///< otherwise may be null
};
struct BlockStatement {
    Statements statements;
};

struct Statement {
    Location at; ///< location of the name in a `val`, and of the first word in any other statement
    std::variant<ValStatement, DefineStatement, Declaration, ConnectionDeclaration, EdgeChannelDeclaration,
                 ParameterSetting, SetStatement, ConnectStatement, UseStatement, PlaceStatement, FaultStatement,
                 RepStatement, IfStatement, BlockStatement>
        form;
};

/// Functions throw this exception if they cannot continue with a statement. They report the error first. The exception
/// is caught where the statement is executed or parsed.
struct StatementRefused {};

} // namespace placedpar
