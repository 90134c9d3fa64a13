#include "runtime/transputer/instruction.hpp"

#include <array>
#include <cstddef>

namespace placedpar::transputer {
namespace {

/// Removes the underscore that distinguishes a name from a keyword of C++.
constexpr std::string_view without_underscore(std::string_view name) {
    return name.ends_with('_') ? name.substr(0, name.size() - 1) : name;
}

constexpr Instruction instruction_table[] = {
#define NAME(name) without_underscore(#name)
#define FUNCTION(code, name, cycles, extra, accesses, ...)                                                             \
    {NAME(name), code, Unit::direct, cycles, extra, accesses, all_models},
#define OPERATION(code, name, cycles, extra, accesses, models, ...)                                                    \
    {NAME(name), code, Unit::integer, cycles, extra, accesses, models},
// At an operation on reals, the integer unit waits at most until the preceding operations on reals have ended. So if
// each operation on reals counts its own cycles as extra cycles, their sum is an upper bound for the waits.
#define CYCLES(cycles, is_double) [](bool DOUBLE [[maybe_unused]]) -> std::uint16_t { return cycles; }(is_double)
#define REAL(code, name, cycles, accesses, ...)                                                                        \
    {NAME(name), code, Unit::reals, 1, CYCLES(cycles, true), accesses, with_reals, CYCLES(cycles, false)},
#define RESULT(code, name, cycles, accesses, ...)                                                                      \
    {NAME(name), code, Unit::reals, 1, 2 * CYCLES(cycles, true), accesses, with_reals, CYCLES(cycles, false)},
#define SELECTED(code, name, cycles, ...)                                                                              \
    {NAME(name), code, Unit::selected, 1, CYCLES(cycles, true), 0, with_reals, CYCLES(cycles, false)},
#define SCHEDULING(code, name, cycles, models) {NAME(name), code, Unit::scheduler, cycles, 0, 0, models},
#include "runtime/transputer/instructions.inc"
#undef NAME
#undef CYCLES
    {"", 0, Unit::direct, 0, 0, 0, 0}, // go_on
    {"", 0, Unit::direct, 0, 0, 0, 0}, // j_zero
    {"", 0, Unit::direct, 0, 0, 0, 0}, // unknown
};
static_assert(std::size(instruction_table) == static_cast<std::size_t>(Operation::unknown) + 1);

/// The operations of a model, by code.
using OperationTable = std::array<Operation, 0x200>;

constexpr OperationTable operations_in(Models models, bool selected) {
    OperationTable result{};
    result.fill(Operation::unknown);
    for (std::size_t i = 0; i < std::size(instruction_table); ++i) {
        const Instruction& each = instruction_table[i];
        if (each.unit != Unit::direct && (each.unit == Unit::selected) == selected && (each.models & models) != 0)
            result[each.code] = static_cast<Operation>(i);
    }
    return result;
}

constexpr OperationTable operations_of_models[] = {
    operations_in(only(Model::t414), false), operations_in(only(Model::t425), false),
    operations_in(only(Model::t400), false), operations_in(only(Model::t800), false),
    operations_in(only(Model::t805), false)};
constexpr OperationTable selected_operations = operations_in(with_reals, true);

/// The direct functions, by code.
constexpr std::array<Operation, 16> functions = [] {
    std::array<Operation, 16> result{};
    result.fill(Operation::unknown);
    for (std::size_t i = 0; instruction_table[i].unit == Unit::direct && !instruction_table[i].name.empty(); ++i)
        result[instruction_table[i].code] = static_cast<Operation>(i);
    return result;
}();

} // namespace

const Instruction& description_of(Operation operation) {
    return instruction_table[static_cast<std::size_t>(operation)];
}

Operation function_of(Word code) { return code < functions.size() ? functions[code] : Operation::unknown; }

Operation operation_of(Word code, Model model) {
    const OperationTable& table = operations_of_models[static_cast<std::size_t>(model)];
    return code < table.size() ? table[code] : Operation::unknown;
}

Operation selected_by(Word code) {
    return code < selected_operations.size() ? selected_operations[code] : Operation::unknown;
}

unsigned cycles_of(Operation operation, Model model) {
    return operation == Operation::mul && model == Model::t414 ? 38 : description_of(operation).cycles;
}

bool ends_block(Operation operation) {
    switch (operation) {
    case Operation::j:
    case Operation::call:
    case Operation::cj:
    case Operation::ret:
    case Operation::gcall:
    case Operation::lend:
    case Operation::altend:
    case Operation::unknown: return true;
    default: return description_of(operation).unit == Unit::scheduler;
    }
}

bool counts_words(Operation operation) {
    switch (operation) {
    case Operation::ldlp:
    case Operation::ldnl:
    case Operation::ldnlp:
    case Operation::ldl:
    case Operation::ajw:
    case Operation::stl:
    case Operation::stnl: return true;
    default: return false;
    }
}

bool branches_by_operand(Operation operation) {
    return operation == Operation::j || operation == Operation::call || operation == Operation::cj;
}

CodedInstruction read_instruction(std::span<const std::uint8_t> bytes, Model model) {
    CodedInstruction result;
    for (Word at = 0; at < bytes.size() && at <= most_prefixes; ++at) {
        const Word function = bytes[at] >> 4u;
        result.operand |= bytes[at] & 15;
        if (function == 2) {
            result.operand <<= 4;
        } else if (function == 6) {
            result.operand = ~result.operand << 4;
        } else {
            result.length = at + 1;
            // Only the lowest ten bits of an operation's code count, because compilers pad with prefixes.
            result.operation = function == 15 ? operation_of(result.operand & 0x3ff, model) : function_of(function);
            return result;
        }
    }
    return result;
}

} // namespace placedpar::transputer
