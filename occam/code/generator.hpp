#pragma once

#include "occam/code/emit.hpp"
#include "occam/code/frame.hpp"

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace placedpar::occam {

/// Holds the number of elements of a dimension of an array: a constant, or the word of the workspace that has the
/// number at run time.
struct Extent {
    std::optional<std::int64_t> constant = {};
    Cell cell = {};
};

/// Describes where a value is at run time.
struct Storage {
    enum class Base : std::uint8_t {
        cell,     ///< the value is in the workspace, at `cell`
        pointer,  ///< the value's address is in `cell`
        absolute, ///< the value is `offset` bytes above the start of memory
        constant, ///< the value is a constant after the code, at `label`
        computed
    };
    Base base = Base::cell;
    Cell cell = {};
    Label label = 0;
    std::int64_t offset = 0; ///< bytes
    const Type* type = nullptr;
    std::vector<Extent> extents = {}; ///< sizes of the dimensions whose size the type leaves open
    bool has_index = false;
    bool is_scalar = false; ///< a value shorter than a word that occupies a whole word of the workspace

    bool is_static() const { return !has_index && base != Base::computed; }
};

/// Holds the least and the greatest value of the index of a replicator with constant base and count.
struct Range {
    std::int64_t least, most;
};

/// Generates the machine code of a checked program. Each structure of the tree (occam/language/tree.hpp) has a
/// function. The functions are in several source files, which comments name below.
///
/// A statement begins with an empty register stack, which has three registers. If values are on the stack and
/// depth_of() says that an expression needs more registers than are free, the caller first saves the values in the
/// workspace.
class Generator {
public:
    using Operation = transputer::Operation;

    Generator(const Program&, const CodeOptions&);
    Code generate(const Declaration& main);

private:
    /// Describes a procedure or function. The first call makes its level and its code.
    struct Routine {
        Level* outer = nullptr; ///< level of the code that declares it; null outside of all procedures
        std::string path;       ///< names of the procedures that contain its declaration, each followed by a slash
        Level* level = nullptr;
        Label entry = 0;
        std::string errors =
            {}; ///< for a routine of predef.lib: what an error in it means; reports show the place of the call
    };
    /// Restores the value of a member variable at the end of a C++ scope.
    template <typename T>
    class Kept {
    public:
        explicit Kept(T& variable) : variable_(variable), value_(variable) {}
        Kept(T& variable, T value) : Kept(variable) { variable = value; }
        ~Kept() { variable_ = value_; }
        Kept(const Kept&) = delete;
        Kept& operator=(const Kept&) = delete;

    private:
        T& variable_;
        T value_;
    };

    /// Gives code a place in the source until the end of a scope. Then the place before it applies again.
    class Placed {
    public:
        Placed(Emitter& emitter, const Place& place) : emitter_(emitter), before_(emitter.place()) {
            emitter.line(place);
        }
        ~Placed() { emitter_.line(before_); }
        Placed(const Placed&) = delete;
        Placed& operator=(const Placed&) = delete;

    private:
        Emitter& emitter_;
        Place before_;
    };

    // generator.cpp: instructions and workspace
    [[noreturn]] void refuse(const Place&, const std::string& what) const;
    void op(Operation, std::int64_t operand = 0);
    void count(int effect);
    void constant(std::int64_t);
    void load(const Cell&);
    void store(const Cell&);
    void load_address(const Cell&);
    void load_frame_of(const Level&);
    /// Loads the number of elements of a dimension, plus `more`, on the register stack.
    void load_extent(const Extent&, std::int64_t more = 0);
    void jump(Label);
    void jump_if_false(Label);
    void mark(Label);
    Cell temporary(int words = 1) { return frame_->allocate(words); }
    int registers() const { return 3 - stack_; }
    bool halts() const { return options_.mode == ErrorMode::halt; }
    bool has_reals() const { return (transputer::only(options_.model) & transputer::with_reals) != 0; }
    void settle();
    void clear_error();
    /// Holds what an error means. In the text, {w} stands for the word in the next of the cells, {l} for the INT64, and
    /// {/l} for the kind of an error of a division by the INT64.
    struct ErrorText {
        std::string text;
        std::vector<Cell> cells;
    };
    /// States what an error of the last instruction means. `moved`: words by which the workspace is moved down.
    void fails(ErrorText, int moved = 0);
    void fails(std::string meaning) { fails(ErrorText{std::move(meaning), {}}); }
    void stop_here(const ErrorText& why);
    void stop_here(const std::string& why) { stop_here(ErrorText{why, {}}); }
    void loop(const Cell& control, Label start, const std::function<void()>& body);
    Storage bytes_constant(const Type&, std::span<const std::uint8_t>);

    // compile.cpp
    struct Argument {
        int depth;
        std::function<void()> load;
    };
    using Arguments = std::vector<Argument>;
    void end_run();
    std::vector<CodeChannel> channels_of_main(const Declaration& main, std::int64_t base) const;
    void add_main_argument(Arguments&, const Declaration& parameter, std::int64_t memory);

    // location_code.cpp
    static const Type& plain(const Type&);
    bool is_word(const Type&)
        const; ///< whether the value fits in a register; true for a REAL32 if the processor has no floating-point unit
    static bool is_wide(const Type&); ///< whether the type is an INT64 or REAL64
    bool is_real(const Type&) const;  ///< whether the value is computed on the stack of the floating-point unit
    static bool has_real_type(const Type&);
    static bool is_compound(const Type& type) {
        return type.kind == Type::Kind::array || type.kind == Type::Kind::record;
    }
    static bool is_channel(const Type&);
    static std::int64_t size_of(const Type&); ///< in bytes of memory; for a channel, the size of a pointer
    static std::optional<std::int64_t> fixed_size(const Type&);
    static std::optional<std::int64_t> fixed_bytes(const Storage&);
    Extent outer_extent(const Storage&) const;
    void load_size(const Storage&); ///< in bytes
    Storage locate(const Expression&);
    Storage locate_field(const Subscript&);
    Storage locate_element(const Subscript&);
    void add_index(Storage&, const Extent&, const Expression& index);
    void check_index(const Extent&, const Expression& index);
    void load_base(Storage&);
    void finish_address(Storage&);
    void add_offset(std::int64_t bytes);
    void address(Storage);
    void load(Storage);
    void load_int16(Storage);
    void store(Storage);
    void store_int16();
    const Type* array_of(const Type& element, std::optional<std::uint32_t> count = {});
    int depth_of_location(const Expression&) const;
    std::optional<Range> range_of(const Expression&) const;
    Storage value_in_memory(const Expression&);
    Storage constant_in_memory(const Expression&);
    Storage temporary_location(const Type&);
    Storage in_workspace(const Type&);
    Storage in_vector_space(const Type&);
    Storage pointer_to(Storage);
    void fill_table(const TableLiteral&, const Storage&);
    static std::optional<std::int64_t> constant_of(const Expression&);
    const Type* basic(Basic) const;

    // segment_code.cpp
    Storage locate_segment(const Segment&);
    Extent segment_count(const Segment&, const Extent& all);
    Storage move_to_segment(Storage, const Segment&, const Extent& all, const Extent& count);

    // expression_code.cpp: values of a word
    void expression(const Expression&);
    int depth_of(const Expression&) const;
    int depth_of_binary(const BinaryOperation&) const;
    void binary(const BinaryOperation&);
    void operands(const Expression& left, const Expression& right, bool commutes, int more = 0);
    bool arithmetic_with_constant(const BinaryOperation&);
    void arithmetic(Operator);
    void fit(const Type&, bool checked);
    void shift(const BinaryOperation&);
    void comparison(const BinaryOperation&);
    void logical(const BinaryOperation&);
    void unary(const UnaryOperation&);
    int depth_of_conversion(const Conversion&) const;
    void conversion(const Expression&, const Conversion&);
    void size_of_array(const Expression&);
    void condition(const Expression&, Label if_false);
    /// Evaluates up to three expressions onto the register stack, with the value of the last on top.
    void push(const std::vector<const Expression*>&);
    void value_process(const ValueProcess&, const std::function<void()>& results);

    // wide_code.cpp: INT64
    struct Wide {
        std::optional<std::int64_t> constant = {};
        Cell cell = {};
        bool is_sign = false; ///< the 0 from which a negation subtracts
    };
    enum class WideRoutine : std::uint8_t { multiply, divide, remainder };
    void load_part(const Wide&, int part);
    Wide wide(const Expression&);
    Wide wide_variable(const Wide&);
    Wide wide_copy(Storage);
    void wide_store(const Wide&, Storage);
    void wide_unary(const UnaryOperation&, const Cell& to);
    void wide_binary(const BinaryOperation&, const Cell& to);
    void wide_sum(const Wide&, const Wide&, bool checked, const Cell& to);
    void wide_difference(const Wide&, const Wide&, bool checked, const Cell& to);
    void wide_by_parts(const Wide&, const Wide&, transputer::Operation lower, transputer::Operation upper,
                       const Cell& to);
    static ErrorText wide_error(const Wide&, const std::string& operation, const Wide&);
    void wide_product(const Wide&, const Wide&, const Cell& to);
    void wide_routine(WideRoutine, const Wide&, const Wide&, const Cell& to);
    void wide_shift(const BinaryOperation&, const Cell& to);
    void wide_conversion(const Conversion&, const Cell& to);
    void wide_comparison(const BinaryOperation&);
    void wide_greater(const Wide&, const Wide&);
    void narrow(const Expression& operand, const Type& to);

    // real_code.cpp
    void real(const Expression&);
    Storage real_constant(const Expression&);
    void real_load(Storage);
    void real_store(Storage);
    int depth_of_real(const Expression&) const;
    bool disturbs_reals(const Expression&) const;
    bool is_real_leaf(const Expression&) const;
    void real_operands(const Expression& left, const Expression& right, bool commutes);
    void real_binary(const BinaryOperation&);
    void real_remainder(const Expression& left, const Expression& right);
    void real_negation(const Expression&, const UnaryOperation&);
    void real_conversion(const Expression&, const Conversion&);
    void real_comparison(const BinaryOperation&);
    void real_to_integer(const Conversion&, const Type&);
    void real_to_wide(const Conversion&, const Cell& to);
    static std::string misfit(const Expression& operand, const std::string& type);
    void check_reals(const std::string& meaning = "");
    void begin_reals();

    // routine_code.cpp
    struct RealRoutine {
        std::string name;
        std::vector<const Expression*> operands;
        std::optional<int> mode =
            {};               ///< for a conversion: the mode of rounding, which is the last argument of the routine
        bool negated = false; ///< the routine's result must be inverted
    };
    void declare_library();
    const Declaration& library_routine(const Place&, const std::string& name) const;
    std::optional<RealRoutine> real_routine(const Expression&) const;
    void call_real_routine(const Expression&, const RealRoutine&, const std::vector<Storage>& results);

    // process_code.cpp
    void process(const Process&);
    void assignment(const Assignment&);
    void assign(const Expression& target, const Expression& value);
    void assign_to(const Expression& value, const Storage& target);
    bool is_bits(const Expression& value) const;
    void assign_word(const Expression& value, int depth, const std::function<Storage()>& target);
    void assign_compound(const Expression& value, int depth, const std::function<Storage()>& target);
    void copy(const Storage& source, Storage target);
    bool is_word_of_frame(const Expression& target);
    void store_from(const Storage& value, const Expression& target);
    void check_sizes(const Storage&, const Storage&);
    void multiple_assignment(const Assignment&);
    void sequence(const Sequence&);
    void replicated(const Replicator&, const std::function<void()>& body);
    Cell begin_replication(const Replicator&, Label end);
    /// These two functions generate choices of an IF. They return whether one of the choices is certainly taken, so
    /// that no later code is needed.
    bool choices(const If&, Label done, bool is_last);
    bool choice(const Choice&, Label done, bool is_last);
    void selection(const Case&);
    using Targets = std::vector<std::pair<std::int64_t, Label>>;
    /// These two functions return the value of the selector of a CASE, for messages.
    ErrorText go_to_target(const Expression& value, const Targets&, Label otherwise);
    ErrorText select_wide(const Wide& selector, const Targets&, Label otherwise);
    void select(const Cell& selector, std::span<const Targets::value_type>, Label otherwise);
    void select_by_table(const Cell& selector, const Targets&, Label otherwise);
    void repetition(const While&);

    // declaration_code.cpp
    void declare(const Declaration&);
    void declare_here(const Declaration&);
    void declare_outermost(const Declaration&);
    void declare_variable(const Declaration&, const Variable&);
    void declare_channels(const Declaration&);
    void make_channels(Storage pointers, std::int64_t count);
    Storage seen_as(Storage, const Type&);
    void abbreviate(const Declaration&, const Expression& value, bool is_value);
    void declare_routine(const Declaration&);
    static bool is_aligned(const Storage&);
    Storage aligned(const Storage&, const Declaration&, bool is_value);
    void retype(const Declaration&, const Retyping&);

    // parallel_code.cpp
    void parallel(const Process&, const Parallel&);
    void join(Label done, std::int64_t processes);
    void load_base_of(Frame&);
    void adjust(Frame& from, Frame& to);
    void replicated_parallel(const Process&, const Parallel&);
    void start_components(const Replicator&, std::int64_t components, Level&, const Cell& index, Label start);
    void priority_parallel(const Parallel&);
    void component(const Process&, Frame&, Frame& parent);
    Frame& new_component(const Process&);
    void generate_level(Level&, Label start, std::string name, const std::function<void()>& body);
    void load_table(Level&);

    // channel_code.cpp
    void channel(const Expression&);
    int depth_of_channel(const Expression&) const;
    void transfer(Operation, const std::function<void()>& load_address, const Expression& on,
                  const std::function<void()>& load_count);
    void transfer(Operation, const Storage&, const Expression& on);
    void input(const Input&);
    void store_top(const Expression& target);
    void input_items(const Expression& on, const std::vector<Item>&);
    void input_counted(const Expression& on, const Item&);
    void check_upper_half(const Cell& lower);
    void transfer_elements(Operation, const Storage& array, const Cell& number, std::int64_t unit,
                           const Expression& on);
    void output(const Output&);
    void output_item(const Expression& on, const Expression& value);
    void load_bits(Storage);
    void output_word(const Expression& on, const std::function<void()>& value, int depth, std::int64_t bytes);
    void output_counted(const Expression& on, const Item&);
    void variant_input(const VariantInput&);
    void variant(const Expression& on, const Variant&);
    void check_timer(const Expression& timer);
    void delay(const Delay&);

    // alternation_code.cpp
    /// Describes the code that is executed when an ALT chooses a guard.
    struct Branch {
        const Alternative* alternative;
        Label label;
        std::vector<std::pair<const Declaration*, Cell>> indices; ///< indices of the replicators that contain the guard
        std::vector<const Alternative*> around; ///< nested ALTs that contain the guard, the outermost first
    };
    struct Nest {
        std::unordered_map<const Declaration*, Cell> kept =
            {}; ///< for each index of a replicator: the word that keeps its value at the chosen guard
        std::vector<std::pair<const Declaration*, Cell>> chosen =
            {}; ///< indices of the replicators that contain the present guard, with their words in `kept`
        std::vector<const Alternative*> around =
            {};          ///< nested ALTs that contain the present guard, the outermost first
        Label after = 0; ///< label of the code after the instruction altend
        std::vector<Branch> branches = {};
    };
    void alternation(const Alternation&);
    static bool has_timer(const Alternation&);
    void reserve(const Alternation&, Nest&);
    void enable(const Alternation&);
    void enable(const Alternative&);
    void disable(const Alternation&, Nest&);
    void disable(const Alternative&, Nest&);
    void load_guard(const Alternative&);
    static const Expression* guard_channel(const Alternative&);
    void branch(const Branch&);

    // call_code.cpp
    Routine& routine_of(const Declaration&);
    void generate_routine(const Declaration&, Routine&);
    void bind_parameters(const std::vector<DeclarationBox>&, Level&);
    void return_results(const Function&, Level&);
    void instance(const Process&, const Instance&);
    void call(const Declaration&, const std::vector<const Expression*>& arguments, const std::vector<Storage>& results,
              Arguments more = {});
    static std::vector<const Expression*> pointers_to(const std::vector<Expression>&);
    void add_argument(Arguments&, const Declaration& parameter, const Expression&);
    void add_value(Arguments&, const Expression&);
    Storage channel_table(const TableLiteral&, const Type&);
    void add_pointer(Arguments&, Storage, const Type& parameter);
    void call_with(Routine&, Arguments);
    int words_moved(int low) const;
    void call_moved(Label entry, int moved, const ErrorText& errors);
    bool returns_in_register(const Function&) const;
    void call_function(const Expression&, const std::vector<Storage>& results);

    // predefined_code.cpp
    bool predefined_call(const Expression&, const Call&, const std::vector<Storage>& results);
    bool word_function(const Call&, const std::vector<Storage>& results);
    bool predefined_shift(const Call&);
    bool real_test(const Call&);
    bool real_function(const Expression&, const Call&);
    void real_operands_behind(const Expression& second);
    void real_sign(const Call&, bool copies);
    void move_in_two_dimensions(const Instance&);
    void predefined_instance(const Process&, const Instance&);

    const Program& program_;
    const CodeOptions& options_;
    Emitter emitter_;
    std::list<CodeBuffer> buffers_;
    std::list<Level> levels_;
    std::unordered_map<const Declaration*, Storage> bindings_; ///< never iterated, since the order is not determined
    const Declaration* main_ = nullptr;
    bool is_main_ = false;    ///< the present code belongs to the main procedure itself
    bool is_library_ = false; ///< the present code belongs to a routine of predef.lib
    std::unordered_map<const Declaration*, Range> ranges_;
    std::unordered_map<const Declaration*, std::unique_ptr<Routine>> routines_;
    std::deque<Type> arrays_; ///< types of segments and of words for channels
    Level* level_ = nullptr;
    Frame* frame_ = nullptr;
    double weight_ = 1; ///< rough estimate of how often the present code is executed, for the layout of workspaces
    std::string path_;  ///< names of the procedures that contain the present code, each followed by a slash
    int stack_ = 0;     ///< number of words on the register stack
    int reals_ = 0;     ///< number of values on the stack of the floating-point unit
    bool guards_are_enabled_ = false; ///< the present code is between the instructions alt and altend
    bool checked_ = false;            ///< an instruction since the last settle() may have set Error
};

} // namespace placedpar::occam
