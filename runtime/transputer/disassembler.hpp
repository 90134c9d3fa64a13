#pragma once

#include "runtime/transputer/instruction.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::transputer {

/// The kind of some bytes. `code` is reached from an entry point; `possible_code` is not reached, but looks like code.
enum class Content : std::uint8_t { code, possible_code, data };

/// An instruction or some bytes of data.
struct CodeLine {
    Word at = 0; ///< position of the first byte, counted from 0
    Content content = Content::data;
    CodedInstruction instruction{}; ///< for data, only the length is set
    /// Position of the byte to which the instruction leads or refers, if the code shows it. For lend, startp and ldpi,
    /// the constants loaded before them show it.
    std::optional<Word> target{};
    Operation selected = Operation::unknown; ///< for fpentry: the operation that the constant loaded before it selects
    bool begins_block = false;               ///< execution may come here from elsewhere than the line before
};

/// Sets `target` and `selected` of a line. `before`: the lines that are executed before the instruction, the last line
/// first. Lines of data have no effect.
void find_target(CodeLine&, const std::array<CodeLine, 2>& before);

/// Disassembles bytes: follows the code from its entry points, then looks for code in the rest. There, bytes are data
/// if they do not decode, are text or zeros, or have prefixes that INMOS's assemblers do not make (nfix before another
/// prefix). REQUIRES: at most 2 Gbyte.
std::vector<CodeLine> disassemble(std::span<const std::uint8_t>, std::span<const Word> entries, Model);

/// Published cycles of an instruction, including its prefixes, with code and data on the chip.
struct CycleRange {
    unsigned least = 0;
    std::optional<unsigned> most = 0; ///< no value if it depends on the length of a message
};
/// Returns the cycles of an instruction. For an operation on reals, returns the cycles of the floating-point unit,
/// although the integer unit can continue meanwhile. If the same operation serves REAL32 and REAL64, returns the cycles
/// for REAL32.
CycleRange published_cycles(const CodedInstruction&, Model);

/// Returns whether an instruction is a branch or the end of a process, so that execution may not continue after it.
bool leads_away(Operation);

} // namespace placedpar::transputer
