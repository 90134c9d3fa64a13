#pragma once

#include "runtime/transputer/instruction.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::transputer {

/// What some bytes are: code that an entry point leads to; bytes that no entry point leads to but that look like code;
/// others.
enum class Content : std::uint8_t { code, possible_code, data };

/// An instruction or some bytes of data.
struct CodeLine {
    Word at = 0; ///< number of the first byte, from 0 on
    Content content = Content::data;
    CodedInstruction instruction{}; ///< of data only the length
    /// Number of the byte that the instruction leads or refers to, if the code says it. The constants before lend,
    /// startp and ldpi are taken into account.
    std::optional<Word> target{};
    Operation selected = Operation::unknown; ///< of fpentry after a constant
    bool begins_block = false;               ///< the line before does not lead here alone, or it is not code
};

/// Finds where an instruction leads or what it selects. `before`: the instructions that were executed before it, the
/// last first; other lines have no effect.
void find_target(CodeLine&, const std::array<CodeLine, 2>& before);

/// Follows code from its entry points, then looks for code in the rest. Bytes are data there if they do not decode, are
/// text or zeros, or have prefixes that no assembler makes: nfix before another prefix. REQUIRES: at most 2 Gbyte.
std::vector<CodeLine> disassemble(std::span<const std::uint8_t>, std::span<const Word> entries, Model);

/// Cycles as published, with code and data on the chip and with prefixes.
struct CycleRange {
    unsigned least = 0;
    std::optional<unsigned> most = 0; ///< nothing: it depends on the length of a message
};
/// Returns the cycles of an instruction. An operation on reals has those of the floating-point unit, although the
/// integer unit can go on meanwhile; those of single length, where it depends.
CycleRange published_cycles(const CodedInstruction&, Model);

/// Returns whether execution does not simply go on after an instruction: a branch, or the end of a process.
bool leads_away(Operation);

} // namespace placedpar::transputer
