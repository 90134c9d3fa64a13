#pragma once

#include "occam/language/type.hpp"
#include "runtime/random.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::test {

__extension__ using WideInteger = __int128;

/// A value of any type. Integers and BOOLs are in `integer`, which has more bits than any type of occam.
struct ProgramValue {
    WideInteger integer = 0;
    double real = 0;
};

/// Thrown by the interpreter where the language has an error.
struct ProgramError {};

/// The interpreter's memory. No procedure calls itself, so each declaration has one place.
struct ProgramMemory {
    std::vector<std::vector<ProgramValue>> own;                            ///< the variables, by number
    std::vector<std::span<ProgramValue>> named;                            ///< the variables that each name stands for
    std::map<std::size_t, std::deque<std::vector<ProgramValue>>> messages; ///< messages of each channel, in order
    std::vector<std::int32_t> log;                                         ///< words that the program has noted
};
inline constexpr std::size_t most_logged = 900;

/// An expression: its text in occam, and a function that computes its value.
struct ProgramTerm {
    std::string text;
    std::function<ProgramValue(ProgramMemory&)> value;
    bool is_constant = false;
    std::set<std::size_t> reads = {}; ///< names that the expression reads
};

/// A variable, an element of an array, or a whole array that is one of the program's names.
struct ProgramSpot {
    std::string text;
    std::function<std::span<ProgramValue>(ProgramMemory&)> cells;
    std::size_t name = 0;
    std::set<std::size_t> reads = {}; ///< names in subscripts
};

/// A process: its text in occam, and a function with the same effect.
struct ProgramStep {
    std::string text; ///< lines of the process
    std::function<void(ProgramMemory&)> act;
};

/// Returns processes one after the other, below a SEQ.
ProgramStep in_sequence(const std::vector<ProgramStep>&);

/// A random program with an interpreter for it, which shares nothing with the compiler. `body` and `declarations` are
/// for execute(). The program notes values in `memory`. The last word but one is the number of values, and the program
/// sets the last word to 1 at its end.
class RandomProgram {
public:
    RandomProgram(std::uint64_t seed, bool has_reals);

    std::string text; ///< lines of a process
    struct Outcome {
        std::vector<std::int32_t> log;
        bool is_error = false;
    };
    Outcome interpreted() const;

private:
    using Basic = occam::Basic;
    struct Name {
        std::string text;
        Basic type{};
        std::vector<std::uint32_t> sizes; ///< empty for a scalar
        std::size_t number = 0;
        bool is_writable = true;
        std::size_t cells() const;
    };
    struct FunctionName {
        std::string text;
        Basic type;
        Name first, second; ///< parameters: `first` has the function's type, `second` is an INT
        std::function<ProgramValue(ProgramMemory&)> body;
    };
    struct ProcedureName {
        std::string text;
        Name value, reference, array; ///< parameters: VAL, by reference, and an open array
        bool logs = false;
        std::function<void(ProgramMemory&)> body;
    };

    // Expressions (random_terms.cpp)
    ProgramTerm term(Basic, int depth);
    ProgramTerm variable_term(Basic, int depth);
    ProgramTerm leaf(Basic);
    ProgramTerm literal(Basic);
    ProgramTerm masked(Basic, const ProgramTerm&, int bits);
    ProgramTerm condition(int depth);
    ProgramTerm comparison(int depth);
    ProgramTerm integer_operation(Basic, int depth);
    ProgramTerm checked_operation(Basic, int depth);
    ProgramTerm shift(Basic, int depth);
    ProgramTerm real_operation(Basic, int depth);
    ProgramTerm conversion(Basic to, int depth);
    ProgramTerm call(const FunctionName&, int depth);
    ProgramTerm scalar_term(Basic);
    ProgramTerm subscript(std::uint32_t size);
    ProgramSpot element(const Name&);
    bool has_spot(Basic, bool is_written) const;
    ProgramSpot spot(Basic, bool is_written);

    // Processes (random_steps.cpp)
    ProgramStep block(int depth, int steps);
    ProgramStep with_names(std::vector<Name> added, const std::function<ProgramStep()>& inner);
    ProgramStep step(int depth);
    ProgramStep assignment();
    ProgramStep double_assignment();
    ProgramStep array_assignment();
    ProgramStep log();
    ProgramStep choice(int depth);
    ProgramStep selection(int depth);
    ProgramStep loop(int depth);
    ProgramStep replicated(int depth);
    ProgramStep abbreviation(int depth);
    ProgramStep value_abbreviation(int depth);
    ProgramStep retyping(int depth);
    ProgramStep instance();
    ProgramStep initialised(const Name&);
    void freeze(const std::set<std::size_t>& numbers);
    // Parallel processes (random_parallel.cpp)
    ProgramStep parallel(int depth);
    ProgramStep replicated_parallel();
    ProgramStep communication(int depth);
    struct Message;
    ProgramStep sender(const Message&, int depth);
    ProgramStep receiver(const Message&, int depth);
    ProgramStep reception(const Message&, int depth);
    /// Makes two processes that write to different variables.
    std::pair<ProgramStep, ProgramStep> apart(const std::function<ProgramStep()>&, const std::function<ProgramStep()>&);
    // The program (random_program.cpp)
    Name declare(Basic, std::vector<std::uint32_t> sizes, std::string_view stem);
    Name index_name();
    std::vector<std::uint32_t> any_sizes();
    static std::string declaration(const Name&);
    static std::string type_text(Basic, const std::vector<std::uint32_t>& sizes);
    std::string log_procedures() const;
    void add_function();
    void add_procedure();

    template <class Choices>
    const auto& one_of(const Choices& choices) {
        return choices[random_.below(static_cast<std::uint32_t>(choices.size()))];
    }
    Basic any_type();
    std::string fresh(std::string_view stem) { return std::string(stem) + std::to_string(names_count_++); }

    RandomStream random_;
    std::vector<Name> names_; ///< names that are visible
    std::vector<FunctionName> functions_;
    std::vector<ProcedureName> procedures_;
    std::vector<Name> unchanged_;                  ///< a variable of each type, which nothing changes
    std::vector<std::size_t> cells_;               ///< number of cells of each name
    std::size_t names_count_ = 0, subscripts_ = 0; ///< `subscripts_` is the number of subscripts around the present
                                                   ///< expression
    bool has_reals_, may_log_ = true, has_logged_ = false, is_in_function_ = false;
    std::function<void(ProgramMemory&)> act_;
};

int bits_of_type(occam::Basic);
bool is_real_type(occam::Basic);
/// Returns the value. Throws ProgramError if the type does not have it.
ProgramValue fitted(WideInteger, occam::Basic);
ProgramValue fitted_real(double, occam::Basic);
/// Returns the lowest bits of a number as a value of the type.
WideInteger wrapped_to(WideInteger, occam::Basic);
/// Returns the words of a value in the log.
std::vector<std::int32_t> words_of_value(const ProgramValue&, occam::Basic);

} // namespace placedpar::test
