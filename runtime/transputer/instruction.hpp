#pragma once

#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace placedpar::transputer {

using HalfCycles16 = std::uint16_t;

/// The instructions that the engine executes. Instructions that fpentry selects are at the end.
enum class Operation : std::uint8_t {
#define FUNCTION(code, name, cycles, extra, accesses, ...) name,
#define OPERATION(code, name, cycles, extra, accesses, models, ...) name,
#define REAL(code, name, cycles, accesses, ...) name,
#define RESULT(code, name, cycles, accesses, ...) name,
#define SELECTED(code, name, cycles, ...) name,
#define SCHEDULING(code, name, cycles, models) name,
#include "runtime/transputer/instructions.inc"
    go_on,   ///< not an instruction: the block ends here, and execution continues at the operand
    j_zero,  ///< `j 0` of a model that can make it a breakpoint, in decoded code only
    unknown, ///< not an instruction of the model
// These are pairs in decoded code: a direct function joined with a frequent function that follows it. The engine then
// need not look up the second function.
#define FUNCTION(code, name, ...) name##_ldl, name##_ldc, name##_ldlp, name##_stl, name##_adc,
#include "runtime/transputer/instructions.inc"
};

/// The direct functions that can be the second of a pair, in the order of the names above.
inline constexpr Operation seconds_of_pairs[] = {Operation::ldl, Operation::ldc, Operation::ldlp, Operation::stl,
                                                 Operation::adc};

/// Returns the pair of two direct functions that follow each other, or `first` if they are not joined. The first
/// function of a pair neither branches nor writes to the memory. Otherwise the engine could execute a second function
/// that the first has overwritten.
constexpr Operation pair_of(Operation first, Operation second) {
    if (first != Operation::ldlp && first != Operation::ldl && first != Operation::ldc && first != Operation::ldnl &&
        first != Operation::ldnlp && first != Operation::adc && first != Operation::eqc)
        return first;
    for (unsigned i = 0; i < std::size(seconds_of_pairs); ++i)
        if (seconds_of_pairs[i] == second)
            return static_cast<Operation>(static_cast<unsigned>(Operation::j_ldl) +
                                          std::size(seconds_of_pairs) * static_cast<unsigned>(first) + i);
    return first;
}
/// Returns the first operation of a pair, or else the operation itself.
constexpr Operation first_of(Operation operation) {
    const unsigned pairs = static_cast<unsigned>(Operation::j_ldl), number = static_cast<unsigned>(operation);
    return number < pairs ? operation : static_cast<Operation>((number - pairs) / std::size(seconds_of_pairs));
}

/// How an instruction is executed.
enum class Unit : std::uint8_t { direct, integer, scheduler, reals, selected };

/// The description of an instruction.
struct Instruction {
    std::string_view name; ///< INMOS's name
    Word code;             ///< code of a direct function or operation, or the selector of fpentry
    Unit unit;
    std::uint16_t cycles;       ///< with code and data on the chip, without prefixes; 1 for an operation on reals
    std::uint16_t extra_cycles; ///< upper bound for additional cycles (of later waits, for an operation on reals)
    std::uint8_t accesses;      ///< upper bound for the words of data
    Models models;
    std::uint16_t real_cycles = 0; ///< cycles of the floating-point unit; if they vary, the cycles for single length
};

/// Returns the description of an instruction; for `go_on`, `j_zero` and `unknown`, a description without cycles.
const Instruction& description_of(Operation);
/// Returns the direct function of a code from 0 to 15; `unknown` for pfix, nfix and opr.
Operation function_of(Word code);
/// Returns the operation that has this code in a model; `unknown` if there is none.
Operation operation_of(Word code, Model);
/// Returns the operation that fpentry selects.
Operation selected_by(Word code);
/// Returns the cycles of an instruction, without additional cycles of its effect. A T414 multiplies in 38 cycles
/// (commonly stated), others in 40.
unsigned cycles_of(Operation, Model);
/// Returns whether execution never continues with the next instruction of the block: a branch, or an instruction of the
/// scheduler.
bool ends_block(Operation);
/// Returns whether the operand of a direct function counts words.
bool counts_words(Operation);
/// Returns whether the operand is the distance of a branch: j, cj and call.
bool branches_by_operand(Operation);

/// The most prefixes of an instruction. We chose this limit: code needs 7, and compilers pad with some more.
inline constexpr Word most_prefixes = 200;

/// An instruction in memory.
struct CodedInstruction {
    Operation operation = Operation::unknown;
    Word operand = 0; ///< operand with all prefixes; for an operation, its code
    Word length = 0;  ///< bytes with prefixes; 0: the instruction does not end within the bytes
};

/// Returns the instruction that begins with the first of these bytes.
CodedInstruction read_instruction(std::span<const std::uint8_t>, Model);

} // namespace placedpar::transputer
