#pragma once

#include "runtime/transputer/model.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::transputer {

/// An assembled program, as machine code of a transputer.
struct Assembly {
    struct Line {
        Word address;
        std::vector<std::uint8_t> bytes; ///< empty for a label or comment
        std::string source;
    };
    Word origin;
    std::vector<std::uint8_t> bytes; ///< the machine code; the first byte is at the address `origin`
    std::map<std::string, Word, std::less<>> labels;
    std::vector<Line> lines;

    /// Returns the address of a label. Throws std::out_of_range if the program has no such label.
    Word operator[](std::string_view label) const;
    /// Returns the source with the address and the bytes of each line.
    std::string listing() const;
};

/// An error in a program, with its place. Lines and columns count from 1.
struct AssemblyError : std::runtime_error {
    AssemblyError(const std::string& what, std::size_t at_line, std::size_t at_column)
        : runtime_error(what), line(at_line), column(at_column) {}
    std::size_t line, column;
};

/// Assembles a program for the transputer, to be loaded at the address `origin`. Each line has the form
///
///     label: mnemonic operand; mnemonic operand     -- a comment
///
/// with any number of instructions. Label and comment may be missing. Mnemonics are in lower case.
///
/// - A direct function (`ldc`, `stl`, ...) has an operand: a sum of numbers and names such as `table - start + 4`.
/// Numbers are decimal, or hexadecimal after `#`. The assembler adds the prefixes that the operand needs, and makes the
/// shortest code.
/// - `j`, `cj` and `call` go to a label: `j loop`. An operand without labels is a distance in bytes from the next
/// instruction.
/// - `ldpi` with an operand loads the address of a label, wherever the program is loaded. It becomes `ldc label - here;
///   ldpi; here:`.
/// - Other operations (`add`, `startp`, `fpadd`, ...) have no operand. `opr #17C` executes the operation with this
///   code.
/// - Some operations of the floating-point unit have a number that `fpentry` takes from register A. For example,
/// `fpusqrtfirst` becomes `ldc 1; fpentry`.
/// - `.byte`, `.half` and `.word` store sums, separated by commas, as values of 1, 2 and 4 bytes. `.byte` also stores
///   the characters of a text in quotes. `.align` stores zeros up to the next whole word.
/// - `size = 4 + 1` gives a number the name `size` in the lines that follow.
///
/// If a model is given, operations that this model lacks are errors. Throws AssemblyError if the program has an error.
Assembly assemble(std::string_view source, Word origin = 0, std::optional<Model> = std::nullopt);

/// Returns the bytes of one instruction with its prefixes, in the shortest form that has at least `least` bytes.
std::vector<std::uint8_t> encoded(unsigned function, std::int32_t operand, std::size_t least = 1);

} // namespace placedpar::transputer
