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

/// These structures form the syntax tree of a netlist. Parser makes the tree, and Elaborator executes its statements.

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
    Location at; ///< the first token; for an operation with two or three operands, its operator
    std::variant<IntegerLiteral, RealLiteral, TextLiteral, NameUse, UnaryOperation, BinaryOperation,
                 ConditionalOperation, CastOperation, SubscriptOperation, SizeOperation, ArrayConstant>
        form;
    int height = 1; ///< height of this tree; limited, so that recursive functions cannot exhaust the stack
};

/// Names something that the netlist declares, or a part of it, such as `name[1][2].field[3]`.
struct Reference {
    Location at;
    std::string name;
    std::vector<ExpressionPointer> subscripts;
    std::string field; ///< the name after the dot; "" if the text has no dot
    Location field_at;
    std::vector<ExpressionPointer> field_subscripts;
};

/// Holds an attribute, such as `name = value`, or a group of attributes, such as `name (a = 1, b = 2)`.
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
    ExpressionPointer default_value; ///< null for a channel end, and for a parameter without a default
};

/// Holds what is in the parentheses of a declaration. Only a declaration of processes may have an interface.
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
/// Holds a statement such as `name (n = 4);`, which sets parameters of a process, or attributes of a node, a connection
/// or a type of processes.
struct ParameterSetting {
    Reference process;
    std::vector<Attribute> values;
};
/// Holds an option `--set` such as `n = 4` or `p[1].n = 4`. The option sets a constant (`val`), or an attribute or
/// parameter of declared nodes, connections or processes.
struct SetStatement {
    Reference target;
    ExpressionPointer value; ///< null if the text is not an expression, such as a string without quotes
    std::string typed;       ///< the text of the value, as the user typed it
    Location value_at;
    std::vector<Diagnostic> problems; ///< errors of an attempt to parse the text as an expression
    std::size_t place = 0;            ///< position of the option among the options `--set` in order of their names

    /// Returns how precise the target is; a more precise option has precedence. `n` has 0, `p.n` has 1, `p[1].n` has 2,
    /// and each further subscript adds 1.
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
    ExpressionPointer first, count,
        last; ///< `for count` sets `count`, and `to last` sets `last`; the pointer that is not set is null
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
    Location at; ///< place of the name in a `val` statement, and of the first word in any other statement
    std::variant<ValStatement, DefineStatement, Declaration, ConnectionDeclaration, EdgeChannelDeclaration,
                 ParameterSetting, SetStatement, ConnectStatement, UseStatement, PlaceStatement, FaultStatement,
                 RepStatement, IfStatement, BlockStatement>
        form;
};

/// A function that cannot continue with a statement reports the error and throws this exception. The function that
/// parses or executes statements in sequence catches the exception and continues with the next statement.
struct StatementRefused {};

} // namespace placedpar
