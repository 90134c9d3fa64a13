#pragma once

#include "runtime/transputer/instruction.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::transputer {

/// The kind of some bytes: code that is reached from an entry point; bytes that are not reached but look like code;
/// other bytes.
enum class Content : std::uint8_t { code, possible_code, data };

/// An instruction or some bytes of data.
struct CodeLine {
    Word at = 0; ///< number of the first byte, from 0 on
    Content content = Content::data;
    CodedInstruction instruction{}; ///< for data, only the length is set
    /// Number of the byte to which the instruction leads or refers, if the code shows it. The constants before lend,
    /// startp and ldpi are taken into account.
    std::optional<Word> target{};
    Operation selected = Operation::unknown; ///< operation that fpentry selects after a constant
    bool begins_block = false;               ///< execution may come here from a line other than the line before
};

/// Finds where an instruction leads or what it selects. `before`: the lines that are executed before the instruction,
/// the last line first. Lines of data have no effect.
void find_target(CodeLine&, const std::array<CodeLine, 2>& before);

/// Follows code from its entry points, then looks for code in the rest. In the rest, bytes are data if they do not
/// decode, are text or zeros, or have prefixes that no assembler makes (nfix before another prefix). REQUIRES: at most
/// 2 Gbyte.
std::vector<CodeLine> disassemble(std::span<const std::uint8_t>, std::span<const Word> entries, Model);

/// Published cycles of an instruction with its prefixes, with code and data on the chip.
struct CycleRange {
    unsigned least = 0;
    std::optional<unsigned> most = 0; ///< no value: it depends on the length of a message
};
/// Returns the cycles of an instruction. For an operation on reals, returns the cycles of the floating-point unit,
/// although the integer unit can continue meanwhile. If they depend on the length of the reals, returns the cycles for
/// single length.
CycleRange published_cycles(const CodedInstruction&, Model);

/// Returns whether an instruction is a branch or the end of a process, so that execution may not continue after it.
bool leads_away(Operation);

} // namespace placedpar::transputer
