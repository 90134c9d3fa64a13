#pragma once

#include "runtime/transputer/instruction.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Machine code as text.
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

/// Returns an instruction as an assembler has it: "ldl     3". `target` replaces the operand if it is not empty.
std::string print_instruction(const CodedInstruction&, std::string_view target);
/// Returns bytes in hexadecimal, at most six: "21 F5".
std::string print_bytes(std::span<const std::uint8_t>);
/// Returns an address: "#80000070".
std::string print_address(Word);
/// Returns whether execution does not simply go on after an instruction: a branch, or the end of a process.
bool leads_away(Operation);

/// Returns the lines of memory that begins at an address, for at most `most_lines`.
std::string print_memory(std::span<const std::uint8_t>, Word address, std::span<const Word> entries, Model,
                         std::size_t most_lines = std::numeric_limits<std::size_t>::max());

/// Positions in a file.
struct FileRange {
    std::size_t from = 0, until = std::numeric_limits<std::size_t>::max(); ///< `until` is not included
};
/// Writes a bootable file as text: the loader at its beginning, which is code at MemStart, then what the loader reads.
/// Packets in which INMOS's collectors cut the code are put together. What the file has no address for is shown with
/// its position in the file.
void print_bootable(std::span<const std::uint8_t> file, Model, const FileRange&,
                    const std::function<void(std::string_view)>& write);

} // namespace placedpar::transputer
