#pragma once

#include "occam/language/type.hpp"
#include "text/source.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace placedpar::occam {

/// These structures form the syntax tree of an occam program, which the parser makes. The checker (occam/check) later
/// sets the members that are marked "checked", for the code generator (occam/code).

/// Identifies a place in one of the files of a program. Lines and columns count from 1.
struct Place {
    std::uint32_t file = 0; ///< index in Program::files
    std::uint32_t line = 0, column = 0;
    bool operator==(const Place&) const = default;
};

struct Expression;
struct Process;
struct Declaration;
using ExpressionBox = std::unique_ptr<Expression>;
using ProcessBox = std::unique_ptr<Process>;
using DeclarationBox = std::unique_ptr<Declaration>;

// The text of types, before their names are resolved

struct TypeText;

/// Holds an item of a protocol, such as `T` or `count::[]T`.
struct ItemText {
    std::shared_ptr<TypeText> count; ///< for a counted array: type of the count; null for another item
    std::shared_ptr<TypeText> type;
};
/// Holds the protocol after CHAN OF: ANY, a name, or items.
struct ProtocolText {
    bool any = false;
    std::vector<ItemText> items; ///< for a named protocol: one item, whose TypeText has the name
};
struct TypeText {
    Place at;
    struct Channel {
        ProtocolText protocol;
    };
    struct Timer {};
    struct Port {
        std::shared_ptr<TypeText> of;
    };
    struct Named {
        std::string name; ///< name of a DATA TYPE or a protocol
    };
    std::vector<ExpressionBox> dimensions; ///< the outermost first; null for an open dimension `[]`
    std::variant<Basic, Channel, Timer, Port, Named> form;
};

// Expressions

enum class Operator : std::uint8_t {
    add,
    subtract,
    multiply,
    divide,
    remainder, // for all operators from `add` to here, an overflow is an error
    plus,
    minus,
    times, // `plus`, `minus` and `times` compute modulo 2^n
    bit_and,
    bit_or,
    bit_xor,
    shift_left,
    shift_right,
    equal,
    unequal,
    less,
    greater,
    less_or_equal,
    greater_or_equal,
    after,
    logical_and,
    logical_or,
    // the operators below have one operand
    negate,
    minus_modulo,
    bit_not,
    logical_not,
    size
};

/// Holds the value of a constant expression. `bits` is for a scalar: an integer with its sign extended, or the bit
/// pattern of a REAL32 or REAL64. `bytes` is for an array or a record, as in memory (little-endian).
struct Constant {
    std::int64_t bits = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> bytes;
};

/// Holds a use of a name: of a value, a variable, a channel or a timer; as a subscript, also of a field; as an item of
/// an output, also of a tag.
struct NameUse {
    std::string name;
    const Declaration* meaning = nullptr; ///< checked; null for a field or a tag
};
/// Holds a literal such as `42`, `#2A`, `'a'`, `42(INT64)` or `TRUE`.
struct IntegerLiteral {
    std::uint64_t value = 0;
    bool negative_allowed =
        false;                  ///< the literal directly follows a minus sign, so that a type of n bits allows 2^(n-1)
    std::optional<Basic> type;  ///< the stated type; BYTE for a character, BOOL for TRUE and FALSE; nothing: INT
    std::string type_name = {}; ///< name of a DATA TYPE, as in `42(LENGTH)`
};
/// Holds a literal such as `1.5(REAL32)`, with its digits as text.
struct RealLiteral {
    std::string digits;
    std::optional<Basic> type;
    std::string type_name = {}; ///< name of a DATA TYPE, as in `1.5(LENGTH)`
};
/// Holds the bytes of a string, without escapes. A string that begins with the escape `*l` has its length as the first
/// byte.
struct StringLiteral {
    std::string bytes;
};
/// Holds a table `[a, b, c]`. If the name of a record type follows, the table is a record literal.
struct TableLiteral {
    std::vector<Expression> elements;
    std::shared_ptr<TypeText> type;
};
struct UnaryOperation {
    Operator operation{};
    ExpressionBox operand;
};
struct BinaryOperation {
    Operator operation{};
    ExpressionBox left, right;
};
/// Holds a conversion such as `INT x`, `REAL32 ROUND x` or `INT TRUNC x`.
struct Conversion {
    enum class Rounding : std::uint8_t { none, round, truncate };
    std::shared_ptr<TypeText> to;
    Rounding rounding = Rounding::none;
    ExpressionBox operand;
};
/// Holds an expression `a[i]` or `record[field]`.
struct Subscript {
    ExpressionBox array, index;
    std::optional<std::uint32_t> field; ///< checked: index among the record's fields
};
/// Holds a segment `[a FROM i FOR n]`. In `[a FOR n]`, `from` is null; in `[a FROM i]`, `count` is null.
struct Segment {
    ExpressionBox array, from, count;
};
/// Holds a call of a function or of a predefined function. If the name is a DATA TYPE, the call is a conversion.
struct Call {
    std::string name;
    std::vector<Expression> arguments;
    const Declaration* meaning = nullptr; ///< checked
};
/// Holds `(VALOF ... RESULT ...)`: specifications, a process, and results.
struct ValueProcess {
    std::vector<DeclarationBox> declarations;
    ProcessBox process;
    Place results_at; ///< the word RESULT, or the first character after IS
    std::vector<Expression> results;
};
/// Holds `MOSTPOS INT`, `MOSTNEG INT` or `BYTESIN (T)`.
struct TypeBound {
    enum class Which : std::uint8_t { most_positive, most_negative, bytes_in };
    Which which{};
    std::shared_ptr<TypeText> of;
};
/// Holds `OFFSETOF (R, field)`.
struct OffsetOf {
    std::shared_ptr<TypeText> of;
    std::string field;
};

struct Expression {
    Place at; ///< the first character; for an operation with two operands, the operator
    std::variant<NameUse, IntegerLiteral, RealLiteral, StringLiteral, TableLiteral, UnaryOperation, BinaryOperation,
                 Conversion, Subscript, Segment, Call, ValueProcess, TypeBound, OffsetOf>
        form;
    std::optional<bool> written_output =
        {}; ///< true for `c!`, false for `c?`, where a channel is passed or abbreviated with a direction
    const Type* type = nullptr;       ///< checked; for a call with several results, the type of the first
    std::optional<Constant> constant; ///< checked: the value, if it is known at compile time
};

// Processes

/// Holds `i = base FOR count STEP step`.
struct Replicator {
    DeclarationBox index; ///< its form is ReplicatorIndex
    Expression base, count;
    ExpressionBox step; ///< null without STEP
};

struct Skip {};
struct Stop {};
/// Holds `a, b := e, f`. One call of a function may give several values.
struct Assignment {
    std::vector<Expression> targets, values;
};
/// Holds an item of an input or an output: a value `x`, or a counted array `n::a`.
struct Item {
    Expression value;
    ExpressionBox counted_array; ///< for `n::a`: the array `a`; `value` is then the count `n`. Null for another item
};
/// Holds `c ? x; n::a`. The channel may also be a timer, as in `clock ? x`, or a port.
struct Input {
    Expression channel;
    std::vector<Item> items;
};
/// Holds `clock ? AFTER e`.
struct Delay {
    Expression timer, time;
};
/// Holds one branch of `c ? CASE`: the tag and items `tag; x`, and the process below them. The short form `c ? CASE
/// tag; x` has one branch, without a process.
struct Variant {
    Place at;                                 ///< the tag
    std::vector<DeclarationBox> declarations; ///< before the tag
    std::string tag;
    std::vector<Item> items;
    ProcessBox process;
    std::optional<std::uint8_t> tag_value; ///< checked
};
struct VariantInput {
    Expression channel;
    std::vector<Variant> variants;
};
/// Holds `c ! e; n::a`. For a variant protocol, the first item is the name of the tag.
struct Output {
    Expression channel;
    std::vector<Item> items;
    std::optional<std::uint8_t> tag_value; ///< checked: the byte of the tag, if the first item is a tag
};
struct Sequence {
    std::optional<Replicator> replicator;
    bool is_do = false;             ///< true for a `DO` of a configuration, whose statements have no order
    std::vector<Process> processes; ///< exactly one if there is a replicator
};
struct Parallel {
    enum class Kind : std::uint8_t { plain, priority, placed };
    Kind kind = Kind::plain;
    std::optional<Replicator> replicator;
    std::vector<Process> processes;
};
struct If;
/// Holds a condition and its process, or a nested IF.
struct Choice {
    Place at;                                 ///< the condition, or the nested IF
    std::vector<DeclarationBox> declarations; ///< before the condition
    ExpressionBox condition;                  ///< null if `nested`
    ProcessBox process;                       ///< null if `nested`
    std::unique_ptr<If> nested;
};
struct If {
    std::optional<Replicator> replicator;
    std::vector<Choice> choices;
};
struct Option {
    Place at; ///< the first value, or ELSE
    std::vector<DeclarationBox> declarations;
    std::vector<Expression> values; ///< empty for ELSE
    ProcessBox process;
};
struct Case {
    Expression selector;
    std::vector<Option> options;
};
struct While {
    Expression condition;
    ProcessBox process;
};
struct Alternation;
/// Holds a guard and its process, or a nested ALT. In the guard `condition & SKIP`, `guard` is Skip.
struct Alternative {
    Place at; ///< the guard, or the nested ALT
    std::vector<DeclarationBox> declarations;
    ExpressionBox condition; ///< null without `condition &`
    std::variant<Skip, Input, Delay, VariantInput, std::unique_ptr<Alternation>> guard;
    ProcessBox process; ///< null for a nested ALT, and for a VariantInput, since its variants have the processes
};
struct Alternation {
    bool has_priority = false;
    std::optional<Replicator> replicator;
    std::vector<Alternative> alternatives;
};
/// Holds a call of a procedure: `name (arguments)`. Its meaning is a Procedure or Predefined.
struct Instance {
    std::string name;
    std::vector<Expression> arguments;
    const Declaration* meaning = nullptr; ///< checked
};
/// Holds declarations and the process that follows them.
struct Scope {
    std::vector<DeclarationBox> declarations;
    ProcessBox process;
};
/// Holds `PROCESSOR n T8` or `PROCESSOR node` of a configuration, and its process.
struct Processor {
    Expression number;
    std::string type; ///< "" if a node is named
    ProcessBox process;
};

/// Holds an end of a CONNECT in a configuration: `node[link][n]`, or an edge.
struct ConnectionEnd {
    Expression path;    ///< a node or an edge
    ExpressionBox link; ///< null for an edge
};
/// Holds a statement such as `CONNECT a[link][0] TO HOST WITH arc`.
struct Connect {
    ConnectionEnd from, to;
    ExpressionBox arc; ///< null without WITH
};
/// Holds one setting of a SET statement: `SET node (type, memsize := "T800", 2*M)` has the settings `type := "T800"`
/// and `memsize := 2*M`.
struct Setting {
    Place at; ///< the name
    std::string name;
    Expression value;
};
struct SetNode {
    Expression node;
    std::vector<Setting> settings;
};
/// Holds `MAP p, q ONTO node PRI HIGH`, or a MAP of channels onto an arc.
struct MapOnto {
    std::vector<Expression> mapped;
    Expression onto;
    ExpressionBox priority; ///< null without PRI
};
/// Holds a statement of the part NETWORK or MAPPING of a configuration.
struct Wiring {
    std::variant<Connect, SetNode, MapOnto> form;
};

struct Process {
    Place at; ///< the first character
    std::variant<Skip, Stop, Assignment, Input, Delay, VariantInput, Output, Sequence, Parallel, If, Case, While,
                 Alternation, Instance, Scope, Processor, Wiring>
        form;
};

// Declarations

/// Holds `INT a:`, `CHAN OF P c:`, `TIMER t:` or `INITIAL INT x IS e:`.
struct Variable {
    std::shared_ptr<TypeText> type;
    ExpressionBox initial;
};
/// Holds `x IS y:` or `VAL INT x IS e:`.
struct Abbreviation {
    bool is_value = false;
    std::shared_ptr<TypeText> type; ///< null if it is left out
    Expression value;
    std::optional<bool> written_output = {}; ///< true for `c!` before IS, false for `c?`
};
/// Holds `T x RETYPES y:` or `VAL T x RETYPES e:`, or the same with RESHAPES.
struct Retyping {
    bool is_value = false, reshapes = false;
    std::shared_ptr<TypeText> type;
    Expression value;
};
/// Holds a parameter of a procedure or function.
struct Parameter {
    enum class Passing : std::uint8_t { reference, value, result };
    Passing passing = Passing::reference;
    std::shared_ptr<TypeText> type;
    std::optional<bool> written_output; ///< true for `c!` as the name, false for `c?`
};
struct ReplicatorIndex {};
struct Procedure {
    std::vector<DeclarationBox> parameters;
    ProcessBox body;
    bool is_inline = false;
};
/// Holds a FUNCTION. If IS defines the function, the body has only results.
struct Function {
    std::vector<std::shared_ptr<TypeText>> results;
    std::vector<DeclarationBox> parameters;
    ValueProcess body;
    bool is_inline = false;
    std::vector<const Type*> result_types; ///< checked
};
struct TagText {
    Place at;
    std::string name;
    std::vector<ItemText> items;
};
/// Holds the declaration of a sequential protocol, or of a variant protocol.
struct Protocol {
    ProtocolText items;
    bool is_variant = false;
    std::vector<TagText> tags;
    const ProtocolType* meaning = nullptr; ///< checked
};
struct DataType {
    struct FieldText {
        Place at;
        std::string name;
        std::shared_ptr<TypeText> type;
    };
    std::shared_ptr<TypeText> is;  ///< the type after `DATA TYPE T IS`; null for a RECORD
    std::vector<FieldText> fields; ///< fields of a RECORD
    bool is_packed = false;
};
/// Holds `PLACE x AT e:`, `PLACE x IN WORKSPACE:` or `PLACE x IN VECSPACE:`. The name of the Declaration is `x`. A
/// configuration may also place elements of arrays, and several channels on an arc: `PLACE c[0], d ON arc:`.
struct Placement {
    enum class Where : std::uint8_t { address, workspace, vector_space, arc };
    Where where = Where::address;
    ExpressionBox address; ///< the address, or the arc if `where` is arc
    std::vector<Expression> paths = {};
    Declaration* placed = nullptr; ///< checked
};
/// Holds a part of a configuration: NETWORK, MAPPING, CONFIG, or a PLACED PAR at the outermost level of a file. The
/// name of the Declaration is this keyword.
struct ConfigurationPart {
    ProcessBox process;
};
/// Holds `#USE "lib"`, which makes the declarations of a file visible.
struct Use {
    std::size_t unit = 0; ///< index in Program::units
};
/// Describes a procedure or function of the language itself, such as LONGADD or ASSERT.
struct Predefined {
    std::vector<const Type*> parameters, results;
    std::vector<Parameter::Passing> passing = {}; ///< how each parameter is passed
};

/// States what the program does with a channel within the channel's scope.
enum class Direction : std::uint8_t { unused, input, output };

struct Declaration {
    Place at;         ///< place of the name
    Place start = {}; ///< the first character of a declaration that is a statement of its own
    std::string name;
    std::variant<Variable, Abbreviation, Retyping, Parameter, ReplicatorIndex, Procedure, Function, Protocol, DataType,
                 Placement, Use, Predefined, ConfigurationPart>
        form;
    const Type* type = nullptr;       ///< checked: type of a value, channel or timer
    std::optional<Constant> constant; ///< checked: value of a VAL abbreviation, if it is known at compile time
    Direction direction =
        Direction::unused; ///< checked: direction in which a channel or channel parameter is used within its scope
    const Placement* placement = nullptr; ///< checked: the PLACE of this variable or channel; null if there is none
};

/// Holds the declarations of a file that #USE names, such as a library.
struct Unit {
    std::string name;
    std::uint32_t file = 0; ///< index in Program::files
    std::vector<DeclarationBox> declarations;
};

/// Holds a place where a name is used or declared, and its declaration.
struct ResolvedName {
    Place at;
    const Declaration* meaning = nullptr;
};

/// Holds a program and all its files.
struct Program {
    std::vector<std::shared_ptr<const SourceFile>> files; ///< the first is the main file
    std::vector<std::unique_ptr<Unit>> units;             ///< ordered so that each unit uses only earlier units
    std::vector<DeclarationBox> declarations;             ///< declarations of the main file
    std::vector<DeclarationBox> predefined;               ///< declarations of predefined names, which the checker adds
    /// Holds the routines of the library predef. The generated code calls them where the program calls predefined
    /// routines, and for operations on reals for which the processor has no instructions.
    std::vector<DeclarationBox> routines;
    Types types;
    /// True if a table of channels `[c, d]` may be passed as an array of channels. Occam does not have such tables.
    /// They are for the program that PlacedPar itself writes to run all processes of a node.
    bool has_channel_tables = false;
    std::vector<ResolvedName> resolved; ///< checked: all uses and declarations of names
    bool is_configuration = false;      ///< the program has a ConfigurationPart, so that NODE, ARC and EDGE are types

    Location location(const Place& place) const { return {files[place.file], place.line, place.column}; }
};

/// Returns the type as text in occam, such as "[4][]BYTE" or "CHAN OF INT::[]BYTE".
std::string name_of(const Type&);
/// Returns the number of bytes of a value in memory. REQUIRES: the type is basic, a record, a derived type, or an array
/// of known size.
std::uint64_t bytes_of(const Type&);
/// Returns 4 if the type has parts of a word or more, which must begin at an address that is a multiple of 4, and
/// otherwise 1. REQUIRES: as bytes_of, but arrays may be of any size.
std::uint32_t word_alignment_of(const Type&);
/// Returns whether a channel can carry the requests and replies of the host: its protocol is ANY, or counted bytes as
/// in `PROTOCOL SP IS INT16::[]BYTE`.
bool carries_host_protocol(const Type&);

} // namespace placedpar::occam
