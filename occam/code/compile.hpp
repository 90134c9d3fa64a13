#pragma once

#include "occam/code/code.hpp"
#include "runtime/transputer/image.hpp"

#include <cstdint>
#include <vector>

namespace placedpar::occam {

/// If the main procedure has a parameter `[]INT memory`, it gets free memory of this size.
inline constexpr std::int64_t bytes_of_free_memory = 256 * 1024;

/// Compiles an occam program into machine code. `main` is the procedure that is executed. Throws RefusedText if the
/// program has a construct that this compiler does not support. REQUIRES: the program was checked without errors.
Code compile(const Program&, const Declaration& main, const CodeOptions&);

/// Returns the address of the code in a transputer's memory, in bytes from the start of memory. The memory for arrays
/// (vector space) follows the code, then the free memory of the main procedure.
std::uint32_t where_code_is(const Code&, const CodeOptions&);

/// Returns the contents of a bootable file that runs the program on one transputer. It has a loader, which moves the
/// code to its place, then the code.
std::vector<std::uint8_t> bootable(const Code&, const CodeOptions&);

/// Returns the contents of a transputer's memory at the beginning of a run of this program, for a run without booting.
transputer::Image image_of(const Code&, const CodeOptions&);

} // namespace placedpar::occam
