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

/// The tree of a program. The parser makes it; the members that are marked "checked" are filled by the check of names
/// and types (occam/check), and are required by the code generator (occam/code).

/// A place in one of the files of a program. Lines and columns count from 1.
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

// Types as they are written

struct TypeText;

/// `T` or `count::[]T` in a protocol.
struct ItemText {
    std::shared_ptr<TypeText> count; ///< null unless the array is counted
    std::shared_ptr<TypeText> type;
};
/// The protocol after CHAN OF: ANY, a name, or items.
struct ProtocolText {
    bool any = false;
    std::vector<ItemText> items; ///< a name alone is one item: a TypeText with a name
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
        std::string name; ///< a DATA TYPE or a protocol
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
    remainder, // checked
    plus,
    minus,
    times, // modulo 2^n
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
    // of one operand
    negate,
    minus_modulo,
    bit_not,
    logical_not,
    size
};

/// The value of a constant expression. Scalars are in `bits`, sign-extended if they are integers; REAL32 and REAL64 by
/// their bit pattern. Arrays and records are in `bytes`, as in memory, little-endian.
struct Constant {
    std::int64_t bits = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> bytes;
};

/// A name of a value, a variable, a channel, a timer, a field (as a subscript) or a tag (as an item).
struct NameUse {
    std::string name;
    const Declaration* meaning = nullptr; ///< checked; null for a field or a tag
};
/// `42`, `#2A`, `'a'`, `42(INT64)`, `TRUE`.
struct IntegerLiteral {
    std::uint64_t value = 0;
    bool negative_allowed = false; ///< it directly follows a minus sign, and may be 2^(n-1)
    std::optional<Basic> type;     ///< as written or by its form: BYTE of a character, BOOL of TRUE; else INT
    std::string type_name = {};    ///< `42(LENGTH)`: a DATA TYPE
};
/// `1.5(REAL32)`: digits as written.
struct RealLiteral {
    std::string digits;
    std::optional<Basic> type;
    std::string type_name = {}; ///< `1.5(LENGTH)`: a DATA TYPE
};
/// A string with its escapes resolved. `*l` in front has been replaced by the length.
struct StringLiteral {
    std::string bytes;
};
/// `[a, b, c]`, perhaps followed by a type: a record literal.
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
/// `INT x`, `REAL32 ROUND x`, `INT TRUNC x`.
struct Conversion {
    enum class Rounding : std::uint8_t { none, round, truncate };
    std::shared_ptr<TypeText> to;
    Rounding rounding = Rounding::none;
    ExpressionBox operand;
};
/// `a[i]`, `record[field]`.
struct Subscript {
    ExpressionBox array, index;
    std::optional<std::uint32_t> field; ///< checked: index among the record's fields
};
/// `[a FROM i FOR n]`; `[a FOR n]` and `[a FROM i]` have a null.
struct Segment {
    ExpressionBox array, from, count;
};
/// A call of a function or of a predefined one. With the name of a DATA TYPE it is a conversion.
struct Call {
    std::string name;
    std::vector<Expression> arguments;
    const Declaration* meaning = nullptr; ///< checked
};
/// `(VALOF ... RESULT ...)`: specifications, a process, results.
struct ValueProcess {
    std::vector<DeclarationBox> declarations;
    ProcessBox process;
    std::vector<Expression> results;
};
/// `MOSTPOS INT`, `MOSTNEG INT`, `BYTESIN (T)`.
struct TypeBound {
    enum class Which : std::uint8_t { most_positive, most_negative, bytes_in };
    Which which{};
    std::shared_ptr<TypeText> of;
};
/// `OFFSETOF (R, field)`.
struct OffsetOf {
    std::shared_ptr<TypeText> of;
    std::string field;
};

struct Expression {
    Place at; ///< the first character; an operation with two operands is at its operator
    std::variant<NameUse, IntegerLiteral, RealLiteral, StringLiteral, TableLiteral, UnaryOperation, BinaryOperation,
                 Conversion, Subscript, Segment, Call, ValueProcess, TypeBound, OffsetOf>
        form;
    std::optional<bool> written_output = {}; ///< `c!` or `c?`: a channel that is passed or abbreviated
    const Type* type = nullptr;              ///< checked; of a call with several results: that of the first
    std::optional<Constant> constant;        ///< checked: the value, if it is known at compile time
};

// Processes

/// `i = base FOR count STEP step`
struct Replicator {
    DeclarationBox index; ///< its form is ReplicatorIndex
    Expression base, count;
    ExpressionBox step; ///< null without STEP
};

struct Skip {};
struct Stop {};
/// `a, b := e, f`; one call of a function may give several values.
struct Assignment {
    std::vector<Expression> targets, values;
};
/// An item of an input or an output: `x`, or `n::a`.
struct Item {
    Expression value;
    ExpressionBox counted_array; ///< null unless the item is counted; then `value` is the count
};
/// `c ? x; n::a`. Also `clock ? x`, whose channel is a timer, and a port.
struct Input {
    Expression channel;
    std::vector<Item> items;
};
/// `clock ? AFTER e`
struct Delay {
    Expression timer, time;
};
/// `tag; x` as an option of `c ? CASE`, with its process; `c ? CASE tag; x` has one without a process.
struct Variant {
    Place at;
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
/// `c ! e; n::a`. The first item of a variant protocol is its tag, as a name.
struct Output {
    Expression channel;
    std::vector<Item> items;
    std::optional<std::uint8_t> tag_value; ///< checked: the first item is a tag
};
struct Sequence {
    std::optional<Replicator> replicator;
    bool is_do = false;             ///< `DO` of a configuration, whose statements have no order
    std::vector<Process> processes; ///< exactly one if there is a replicator
};
struct Parallel {
    enum class Kind : std::uint8_t { plain, priority, placed };
    Kind kind = Kind::plain;
    std::optional<Replicator> replicator;
    std::vector<Process> processes;
};
struct If;
/// A condition with its process, or a nested IF.
struct Choice {
    Place at;
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
    Place at;
    std::vector<DeclarationBox> declarations;
    std::vector<Expression> values; ///< none: ELSE
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
/// A guard with its process, or a nested ALT. A guard without an input is `condition & SKIP`.
struct Alternative {
    Place at;
    std::vector<DeclarationBox> declarations;
    ExpressionBox condition; ///< null without `condition &`
    std::variant<Skip, Input, Delay, VariantInput, std::unique_ptr<Alternation>> guard;
    ProcessBox process; ///< null for a nested ALT and for a VariantInput, whose variants have processes
};
struct Alternation {
    bool has_priority = false;
    std::optional<Replicator> replicator;
    std::vector<Alternative> alternatives;
};
/// `name (arguments)`; the meaning is a Procedure or a predefined one.
struct Instance {
    std::string name;
    std::vector<Expression> arguments;
    const Declaration* meaning = nullptr; ///< checked
};
/// Specifications and the process that follows them.
struct Scope {
    std::vector<DeclarationBox> declarations;
    ProcessBox process;
};
/// `PROCESSOR n T8` or `PROCESSOR node` with its process, in configurations only.
struct Processor {
    Expression number;
    std::string type; ///< "" of a node
    ProcessBox process;
};

/// An end of a connection: `node[link][n]`, or an edge.
struct ConnectionEnd {
    Expression path;    ///< a node or an edge
    ExpressionBox link; ///< null for an edge
};
/// `CONNECT a[link][0] TO HOST WITH arc`
struct Connect {
    ConnectionEnd from, to;
    ExpressionBox arc; ///< null without WITH
};
/// `type := "T800"` within `SET node (type, memsize := "T800", 2*M)`.
struct Setting {
    Place at; ///< the name
    std::string name;
    Expression value;
};
struct SetNode {
    Expression node;
    std::vector<Setting> settings;
};
/// `MAP p, q ONTO node PRI HIGH`, or channels onto an arc.
struct MapOnto {
    std::vector<Expression> mapped;
    Expression onto;
    ExpressionBox priority; ///< null without PRI
};
/// A statement of NETWORK or MAPPING.
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

/// `INT a:`, `CHAN OF P c:`, `TIMER t:`, `INITIAL INT x IS e:`
struct Variable {
    std::shared_ptr<TypeText> type;
    ExpressionBox initial;
};
/// `x IS y:`, `VAL INT x IS e:`
struct Abbreviation {
    bool is_value = false;
    std::shared_ptr<TypeText> type; ///< null if it is left out
    Expression value;
    std::optional<bool> written_output = {}; ///< `c!` or `c?` in front of IS
};
/// `T x RETYPES y:`, `VAL T x RETYPES e:`, RESHAPES
struct Retyping {
    bool is_value = false, reshapes = false;
    std::shared_ptr<TypeText> type;
    Expression value;
};
/// A parameter of a procedure or function.
struct Parameter {
    enum class Passing : std::uint8_t { reference, value, result };
    Passing passing = Passing::reference;
    std::shared_ptr<TypeText> type;
    std::optional<bool> written_output; ///< `c!` or `c?` after the name
};
struct ReplicatorIndex {};
struct Procedure {
    std::vector<DeclarationBox> parameters;
    ProcessBox body;
    bool is_inline = false;
};
/// The body of a function by `IS` has neither declarations nor a process.
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
/// A sequential protocol, or a variant one if it has tags.
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
    std::shared_ptr<TypeText> is;  ///< of DATA TYPE T IS ...
    std::vector<FieldText> fields; ///< of a RECORD
    bool is_packed = false;
};
/// `PLACE x AT e:`, `PLACE x IN WORKSPACE:`, `PLACE x IN VECSPACE:`. Its name is the name of the placed thing. A
/// configuration may place elements, and several channels on an arc: `PLACE c[0], d ON arc:`.
struct Placement {
    enum class Where : std::uint8_t { address, workspace, vector_space, arc };
    Where where = Where::address;
    ExpressionBox address; ///< or the arc
    std::vector<Expression> paths = {};
    Declaration* placed = nullptr; ///< checked
};
/// NETWORK, MAPPING, CONFIG, or a PLACED PAR that stands at the outermost level of a file. Its name is the word.
struct ConfigurationPart {
    ProcessBox process;
};
/// `#USE "lib"`: the declarations of that file become visible.
struct Use {
    std::size_t unit = 0; ///< index in Program::units
};
/// A procedure or function of the language itself, such as LONGADD or ASSERT.
struct Predefined {
    std::vector<const Type*> parameters, results;
    std::vector<Parameter::Passing> passing = {}; ///< how each parameter is passed
};

/// How a PROC uses a channel parameter or a declared channel.
enum class Direction : std::uint8_t { unused, input, output };

struct Declaration {
    Place at; ///< its name
    std::string name;
    std::variant<Variable, Abbreviation, Retyping, Parameter, ReplicatorIndex, Procedure, Function, Protocol, DataType,
                 Placement, Use, Predefined, ConfigurationPart>
        form;
    const Type* type = nullptr;              ///< checked: of what has a value, of channels and timers
    std::optional<Constant> constant;        ///< checked: of VAL abbreviations that are known at compile time
    Direction direction = Direction::unused; ///< checked: of a channel or channel parameter, within its scope
    const Placement* placement = nullptr;    ///< checked: null unless it is placed
};

/// A file that #USE names, such as a library: its declarations.
struct Unit {
    std::string name;
    std::uint32_t file = 0; ///< index in Program::files
    std::vector<DeclarationBox> declarations;
};

/// A use of a name, or its declaration, with what it means.
struct ResolvedName {
    Place at;
    const Declaration* meaning = nullptr;
};

/// A program with all of its files.
struct Program {
    std::vector<std::shared_ptr<const SourceFile>> files; ///< the first is the main file
    std::vector<std::unique_ptr<Unit>> units;             ///< in order of use: each uses only earlier ones
    std::vector<DeclarationBox> declarations;             ///< of the main file
    std::vector<DeclarationBox> predefined;               ///< made by the check
    /// The library predef: routines that the code calls for predefined routines and for reals if there are no
    /// instructions.
    std::vector<DeclarationBox> routines;
    Types types;
    /// `[c, d]` of channels is an array of them, as an argument. The language has no such tables, but a program that
    /// joins the processes of a network needs them.
    bool has_channel_tables = false;
    std::vector<ResolvedName> resolved; ///< checked: all names, except those of configurations
    bool is_configuration = false; ///< a ConfigurationPart is among the declarations, so NODE, ARC and EDGE are types

    Location location(const Place& place) const { return {files[place.file], place.line, place.column}; }
};

/// Returns the type as the language writes it: "[4][]BYTE", "CHAN OF INT::[]BYTE".
std::string name_of(const Type&);
/// Returns the bytes of a value in memory. REQUIRES: it is basic, a record, a derived type, or an array of known size.
std::uint64_t bytes_of(const Type&);

} // namespace placedpar::occam
