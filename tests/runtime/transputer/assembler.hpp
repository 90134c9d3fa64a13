#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// A program that an assembler made.
struct Assembly {
    struct Line {
        std::uint32_t address;
        std::vector<std::uint8_t> bytes; ///< empty for a label or comment
        std::string source;
    };
    std::uint32_t origin;
    std::vector<std::uint8_t> bytes; ///< from the origin on
    std::map<std::string, std::uint32_t, std::less<>> labels;
    std::vector<Line> lines;

    /// Returns the address of a label. Throws std::out_of_range if the program has no such label.
    std::uint32_t operator[](std::string_view label) const;
    /// Returns a line of text for each line of the source: address, bytes, source.
    std::string listing() const;
};

/// An error in a program; the message begins with the line's number.
struct AssemblyError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Assembles a program for the transputer, to be loaded at `origin`. Each line has the form
///
///     label: mnemonic operand; mnemonic operand     -- a comment
///
/// with any number of instructions; label and comment may be missing. Mnemonics are in lower case.
///
/// - A direct function (`ldc`, `stl`, ...) has an operand: a sum of numbers and labels such as `table - start + 4`.
///   Numbers are decimal, or hexadecimal after `#`. Prefixes are added as needed; they make the shortest code.
/// - `j`, `cj` and `call` go to a label: `j loop`. An operand without labels is the distance from the next instruction.
/// - Other operations (`add`, `startp`, `fpadd`, ...) have no operand. `opr #17C` executes any code.
/// - An operation that the floating-point unit selects by a number, such as `fpusqrtfirst`, becomes `ldc 1; fpentry`.
/// - `.byte` and `.word` store sums that are separated by commas. `.align` stores zeros up to the next whole word.
///
/// Throws AssemblyError.
Assembly assemble(std::string_view source, std::uint32_t origin = 0);

/// Returns the bytes of one instruction with its prefixes: the shortest that has at least `least` bytes.
std::vector<std::uint8_t> instruction(unsigned function, std::int32_t operand, std::size_t least = 1);

/// Returns the operation's code for `opr`, or -1 if there is no such operation.
int operation_code(std::string_view mnemonic);

} // namespace placedpar::test
