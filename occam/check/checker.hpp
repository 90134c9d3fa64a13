#pragma once

#include "occam/check/change.hpp"
#include "occam/language/tree.hpp"
#include "text/reporter.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace placedpar::occam {

/// Returns the declaration of `a` for a path such as `a[i]` or `[a FROM i FOR n]`; null if the path does not begin with
/// a name.
const Declaration* root_of(const Expression&);
/// Returns the declaration to which an abbreviation or RETYPES gives another name: that of `a` for `x IS a[i]:`.
/// Returns null for an abbreviation or RETYPES with VAL, and for any other declaration.
const Declaration* named_by(const Declaration&);
/// Returns the variable or channel itself for an abbreviation of it, also through several abbreviations. Returns any
/// other declaration unchanged.
const Declaration* base_of(const Declaration*);
/// Returns whether variables can have this type. They cannot be channels, timers or ports.
bool is_data(const Type&);
/// Returns the type of the elements of an array after all its subscripts, INT for `[4][8]INT`. Returns any other type
/// unchanged.
const Type& innermost(const Type&);
/// Returns whether a value of type `given` can be used where type `wanted` is required. An array size that is unknown
/// at compile time fits every size, since the compiled code then compares the sizes.
bool fits(const Type& wanted, const Type& given);

/// Returns whether all operands of an expression are integer literals without a type, so that the expression can take
/// any integer type.
bool is_untyped(const Expression&);

/// Holds the declarations that are visible at the place in the program that is being checked.
class Names {
public:
    void add(Declaration&);
    Declaration* find(const std::string& name) const;
    /// Returns a mark for the end of a scope: leave() hides all names that were added after the mark.
    std::size_t mark() const { return order_.size(); }
    void leave(std::size_t mark);
    std::vector<std::string> all() const;

private:
    std::vector<Declaration*> order_;
    std::unordered_map<std::string, std::vector<Declaration*>> by_name_;
};

/// Describes a PROC, FUNCTION or VALOF that is being checked, and its effects on the outside.
struct Routine {
    const Declaration* declaration = nullptr; ///< null for a VALOF in an expression
    bool is_function = false;
    std::string communicates = {}; ///< first communication in it, such as "an output", for messages; "" if it has none
    std::vector<const Declaration*> assigned = {}; ///< variables declared outside that it changes
    bool has_priority_par = false;
    bool is_inside_priority_par = false; ///< the routine is declared inside a PRI PAR
};

/// Describes a parameter of a called routine.
struct Formal {
    const Type* type = nullptr;
    Parameter::Passing passing = Parameter::Passing::value;
    std::string name = {};
    const Declaration* declaration = nullptr; ///< null for a predefined routine
};

/// Finds the meaning of names, the types and the constants of an occam program. Visits each declaration and process
/// once, in the order of the text. A function that finds an error reports it, and returns the type `mistaken`
/// (occam/language/type.hpp), which causes no further errors.
class Checker {
public:
    /// `change` is called for each declaration at the outermost level: see occam/check/change.hpp.
    Checker(Program& program, Reporter& reporter, ChangeDeclaration change = {})
        : program_(program), reporter_(reporter), types_(program.types), change_(std::move(change)) {}
    void check_program();

    // The public functions below are for the Configurer (occam/configuration). It visits the declarations and processes
    // of a configuration itself: a replicated process once for each value of the index, which is then a constant.

    void check_units();
    /// Checks a declaration, and makes it visible.
    void declare(Declaration&);
    void add(Declaration&);
    std::size_t mark() const { return names_.mark(); }
    /// Hides all declarations that were made visible after the mark.
    void leave(std::size_t mark) { names_.leave(mark); }
    Declaration* find(const std::string& name, const Place&);
    const Type* check(Expression&);
    void check(Process&);
    void constant_of_type(Expression&, const Type* wanted, const std::string& role);
    void report(const Place&, std::string message, std::string hint = "", const Declaration* other = nullptr);
    void report(const Place&, std::string message, std::string hint, std::vector<SecondPlace> others);

private:
    using DeclarationList = std::vector<DeclarationBox>;

    // Names (names.cpp)
    /// Returns whether this is the first mistake of this kind in the use of a declaration. The caller does not report
    /// later mistakes of the kind, since they probably have the same cause.
    bool is_first(const Declaration*, std::string mistake);
    void note(const Place&, const Declaration& meaning);
    void report_unknown(const std::string& name, const Place&);
    /// Checks the declarations in order, and makes them visible. REQUIRES: the caller hides them later, with
    /// names_.leave.
    void declare(DeclarationList&);
    Declaration* predefined(const std::string& name);
    // unused.cpp
    void warn_of_unused();

    // Types as they are written (types.cpp)
    enum class Open : bool { refused, allowed };
    const Type* type_of(TypeText&, Open);
    const Type* named_type(const TypeText&, const std::string& name);
    const Type* innermost_type(TypeText&);
    const Type* with_dimensions(TypeText&, const Type* element, Open);
    std::optional<std::uint32_t> dimension(Expression&);
    const ProtocolType* protocol_of(ProtocolText&, const Place&);
    std::optional<ProtocolItem> item_of(ItemText&);
    std::vector<ProtocolItem> items_of(std::vector<ItemText>&);
    void add_tags(ProtocolType&, Protocol&);
    void add_tag(ProtocolType&, ProtocolTag, const Place&);
    const ProtocolType* shared_protocol(const Declaration&, ProtocolType);
    void require_whole_words(const Declaration&, const Type& record);
    const Type* record_type(const Declaration&, DataType&);

    // Expressions (expressions.cpp)
    const Type* value(Expression&);
    /// Checks a value that must be of this type. `role` names the value in messages, such as "the time".
    void value_of(Expression&, const Type* wanted, const std::string& role);
    /// Checks an expression that must name a variable to which the program writes.
    const Type* variable(Expression&, const std::string& action);
    /// Reports an error if a value does not have the required type.
    bool agrees(Expression&, const Type* wanted, const std::string& role, std::string hint = "");
    bool adapt(Expression&, const Type& wanted);
    std::string conversion_hint(const Expression&, const Type& wanted) const;
    void assigned(const Declaration*, const Place&, const std::string& through);
    const Type* form_of(Expression&, NameUse&);
    const Type* form_of(Expression&, IntegerLiteral&);
    const Type* form_of(Expression&, RealLiteral&);
    const Type* form_of(Expression&, StringLiteral&);
    const Type* form_of(Expression&, TableLiteral&);
    const Type* form_of(Expression&, UnaryOperation&);
    const Type* form_of(Expression&, BinaryOperation&);
    const Type* form_of(Expression&, Conversion&);
    const Type* form_of(Expression&, Subscript&);
    const Type* form_of(Expression&, Segment&);
    const Type* form_of(Expression&, Call&);
    const Type* form_of(Expression&, ValueProcess&);
    const Type* form_of(Expression&, TypeBound&);
    const Type* form_of(Expression&, OffsetOf&);
    const Type* literal_type(const Place&, const std::optional<Basic>&, const std::string& name, Basic by_default);
    const Type* channel_table(TableLiteral&);
    const Type* record_literal(Expression&, TableLiteral&);
    const Type* field_of(Expression&, Subscript&, const Type& record);
    const Type* several(Expression&, const std::vector<const Type*>& results);
    void check_range(const Expression& at, std::int64_t first, std::int64_t count, std::int64_t size, bool is_segment);
    const Type* mistaken() { return types_.mistaken(); }
    const Type* basic(Basic b) { return types_.basic(b); }

    // Operators (operators.cpp)
    const Type* shift(Expression&, BinaryOperation&);
    void check_count(Expression&, const BinaryOperation& shift);
    void fold_binary(Expression&, const BinaryOperation&);
    const Type* size_of(Expression&, UnaryOperation&);
    bool has_operator(const Expression&, Operator, const Type&);
    void become(Expression&, std::int64_t bits, const char* error);

    // Declarations (declarations.cpp)
    void declare(Declaration&, Variable&);
    void declare(Declaration&, Abbreviation&);
    void declare(Declaration&, Retyping&);
    void declare(Declaration&, Parameter&);
    void declare(Declaration&, ReplicatorIndex&) const {}
    void declare(Declaration&, Procedure&);
    void declare(Declaration&, Function&);
    void declare(Declaration&, Protocol&);
    void declare(Declaration&, DataType&);
    void declare(Declaration&, Placement&);
    void declare(Declaration&, Use&);
    void declare(Declaration&, Predefined&) const {}
    void declare(Declaration&, ConfigurationPart&) const {}
    const Type* abbreviated(Expression&);
    const Type* retyped(Declaration&, Retyping&, const Type& from);
    void parameters(DeclarationList&);
    void enter_routine(Routine);
    void leave_routine(std::size_t mark);
    void value_process(ValueProcess&);
    /// Checks the right side of an assignment, and returns the types of its values. A call of a function may have
    /// several values.
    std::vector<const Type*> types_of_values(std::vector<Expression>&);
    std::vector<const Type*> types_of_results(std::vector<Expression>&);
    bool has_values(const Place&, const std::string& role, std::vector<Expression>& values,
                    const std::vector<const Type*>& given, const std::vector<const Type*>& wanted);

    // Calls (calls.cpp)
    std::vector<Formal> formals_of(const Declaration&) const;
    std::vector<const Type*> results_of(const Declaration&) const;
    void arguments(const Place&, const std::string& name, std::vector<Expression>&, const std::vector<Formal>&);
    void argument(Expression&, const Formal&, const std::string& of);
    void effects_of_call(const Declaration&, const Place&);

    // Processes (processes.cpp)
    void form_of(Process&, Skip&) const {}
    void form_of(Process&, Stop&) const {}
    void form_of(Process&, Assignment&);
    void form_of(Process&, Input&);
    void form_of(Process&, Delay&);
    void form_of(Process&, VariantInput&);
    void form_of(Process&, Output&);
    void form_of(Process&, Sequence&);
    void form_of(Process&, Parallel&);
    void form_of(Process&, If&);
    void form_of(Process&, Case&);
    void form_of(Process&, While&);
    void form_of(Process&, Alternation&);
    void form_of(Process&, Instance&);
    void form_of(Process&, Scope&);
    void form_of(Process&, Processor&);
    void form_of(Process&, Wiring&);
    void check_if(If&);
    void check_alternation(Alternation&);
    void check_alternative(Alternative&);
    void check_option(Option&, const Type* selector, std::unordered_map<std::int64_t, Place>& seen);
    void check_replicator(Replicator&);
    void check_priority(const Process&, const Parallel&);

    // Communication (communication.cpp)
    /// Records that a process communicates, which is forbidden in a function. `what` names the communication in
    /// messages.
    void communicates(const Place&, const std::string& what);
    const Type* channel(Expression&, const char* action);
    void use_channel(const Expression&, Direction);
    void mark_direction(const Declaration&, Direction, const Place&);
    void input(const Place&, Input&, bool is_guard);
    void delay(const Place&, Delay&);
    void variant_input(VariantInput&);
    void check_variant(Variant&, const ProtocolType&);
    void input_items(const Place&, std::vector<Item>&, const std::vector<ProtocolItem>&, std::size_t first);
    void input_item(Item&, const ProtocolItem*);
    void output_items(const Place&, std::vector<Item>&, const std::vector<ProtocolItem>&, std::size_t first);
    void output_item(Item&, const ProtocolItem*);
    void output_tag(Output&, const Place&, const ProtocolType&);
    const ProtocolTag* tag_of(const ProtocolType&, const std::string& name, const Place&);
    bool has_items(const Place&, std::size_t given, std::size_t wanted);
    bool has_form(Item&, const ProtocolItem& wanted, Direction);

    Program& program_;
    Reporter& reporter_;
    Types& types_;
    ChangeDeclaration change_;
    Names names_;
    std::vector<Routine> routines_;
    std::unordered_map<const Declaration*, std::size_t>
        depths_; ///< for each declaration: number of routines that contain it
    std::unordered_map<const Declaration*, Routine> effects_;   ///< effects of the checked procedures
    std::unordered_map<const Declaration*, Place> directed_at_; ///< place of the first use of each channel parameter
    std::unordered_map<const TypeText*, const Type*>
        resolved_; ///< type for each type in the text; several declarations may share a type's text
    std::unordered_map<std::string, Declaration*> predefined_;
    std::unordered_set<std::string> reported_;                      ///< unknown names that have been reported
    std::set<std::pair<const Declaration*, std::string>> mistakes_; ///< arguments of the calls of is_first() so far
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>
        noted_; ///< file, line and column of the names of a configuration that are in Program::resolved; a replicated
                ///< process has the same names in each visit
    std::vector<const Declaration*> declared_; ///< all checked declarations, in the order of the text
    std::unordered_set<const Declaration*> used_;
    std::vector<const ProtocolType*> named_protocols_;
    struct Pending {
        const DeclarationList* list;
        std::size_t next;
    };
    std::vector<Pending>
        pending_; ///< lists of declarations that contain the present place, each with the index of its next declaration
    bool several_allowed_ = false; ///< the next expression may be a call with several results
    bool inside_priority_par_ = false;
};

} // namespace placedpar::occam
