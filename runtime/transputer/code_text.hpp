#pragma once

#include "runtime/transputer/instruction.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>

/// Prints a transputer's machine code as text.
namespace placedpar::transputer {

/// Returns an instruction in assembler notation, such as "ldl 3". `target` replaces the operand, unless it is "".
std::string print_instruction(const CodedInstruction&, std::string_view target);
/// Returns at most six bytes in hexadecimal, such as "21 F5".
std::string print_bytes(std::span<const std::uint8_t>);
/// Returns an address: "#80000070".
std::string print_address(Word);
/// Returns disassembled memory, at most `most_lines` lines. `address`: the address of the first byte.
std::string print_memory(std::span<const std::uint8_t>, Word address, std::span<const Word> entries, Model,
                         std::size_t most_lines = std::numeric_limits<std::size_t>::max());

/// Positions in a file.
struct FileRange {
    std::size_t from = 0, until = std::numeric_limits<std::size_t>::max(); ///< `until` is not included
};
/// Writes a bootable file as text. First comes the loader, which is code at MemStart, then the bytes that the loader
/// reads. INMOS's collectors divide the code into packets; the text shows the joined code. Bytes without a known
/// address are shown with their position in the file.
void print_bootable(std::span<const std::uint8_t> file, Model, const FileRange&,
                    const std::function<void(std::string_view)>& write);

} // namespace placedpar::transputer
