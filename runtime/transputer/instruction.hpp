#pragma once

#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace placedpar::transputer {

using HalfCycles16 = std::uint16_t;

/// The instructions that an emulated transputer executes. The file instructions.inc lists them.
enum class Operation : std::uint8_t {
#define FUNCTION(code, name, cycles, extra, accesses, ...) name,
#define OPERATION(code, name, cycles, extra, accesses, models, ...) name,
#define REAL(code, name, cycles, accesses, ...) name,
#define RESULT(code, name, cycles, accesses, ...) name,
#define SELECTED(code, name, cycles, ...) name,
#define SCHEDULING(code, name, cycles, models) name,
#include "runtime/transputer/instructions.inc"
    go_on,   ///< not an instruction: a block of decoded code ends here, and execution continues at the operand
    j_zero,  ///< only in decoded code: `j 0` on a model for which it can be a breakpoint
    unknown, ///< not an instruction of the model
// These are pairs in decoded code: a direct function and a frequent function that follows it. They are executed
// together, which is faster.
#define FUNCTION(code, name, ...) name##_ldl, name##_ldc, name##_ldlp, name##_stl, name##_adc,
#include "runtime/transputer/instructions.inc"
};

/// The direct functions that can be the second of a pair. Their order is that of the names above.
inline constexpr Operation seconds_of_pairs[] = {Operation::ldl, Operation::ldc, Operation::ldlp, Operation::stl,
                                                 Operation::adc};

/// Returns the pair of two direct functions that follow each other, or `first` if they form no pair. The first function
/// of a pair neither branches nor writes to the memory, because a write could overwrite the second function.
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

/// The part of the emulator that executes an instruction. `selected`: an operation on reals that fpentry selects.
enum class Unit : std::uint8_t { direct, integer, scheduler, reals, selected };

/// The description of an instruction.
struct Instruction {
    std::string_view name; ///< INMOS's name
    Word code;             ///< code of a direct function or operation, or the number by which fpentry selects it
    Unit unit;
    std::uint16_t cycles;       ///< with code and data on the chip, without prefixes; for an operation on reals only
                                ///< the integer unit's cycle, 1
    std::uint16_t extra_cycles; ///< upper bound for additional cycles; for an operation on reals, of later waits for
                                ///< the floating-point unit
    std::uint8_t accesses;      ///< upper bound for the number of data words that it accesses
    Models models;
    std::uint16_t real_cycles = 0; ///< cycles of the floating-point unit; if they vary, the cycles for single length
};

/// Returns the description of an instruction. For `go_on`, `j_zero` and `unknown` it has no cycles.
const Instruction& description_of(Operation);
/// Returns the direct function of a code from 0 to 15; `unknown` for pfix, nfix and opr.
Operation function_of(Word code);
/// Returns the operation that has this code in a model; `unknown` if there is none.
Operation operation_of(Word code, Model);
/// Returns the operation that fpentry selects.
Operation selected_by(Word code);
/// Returns the least cycles of an instruction. A T414 multiplies in 38 cycles (commonly stated), other models in 40.
unsigned cycles_of(Operation, Model);
/// Returns whether a block of decoded code ends with this instruction: a branch, or an instruction of the scheduler.
bool ends_block(Operation);
/// Returns whether the operand of a direct function counts words.
bool counts_words(Operation);
/// Returns whether the operand is the distance of a branch: j, cj and call.
bool branches_by_operand(Operation);

/// The most prefixes of an instruction (our choice). Operands need at most 7, and compilers pad with some more.
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
