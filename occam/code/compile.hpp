#pragma once

#include "occam/code/code.hpp"
#include "runtime/transputer/image.hpp"

#include <cstdint>
#include <vector>

namespace placedpar::occam {

/// The free memory that a main procedure gets as `[]INT memory`.
inline constexpr std::int64_t bytes_of_free_memory = 256 * 1024;

/// Compiles a program that was checked without errors. Throws RefusedInput for what this compiler cannot compile.
Code compile(const Program&, const Declaration& main, const CodeOptions&);

/// Returns the address to which the loader moves the code, in bytes from the start of memory. The code is followed by
/// the vector space, then by the free memory that the main procedure gets.
std::uint32_t where_code_is(const Code&, const CodeOptions&);

/// Returns a bootable file that runs the program on one transputer: PlacedPar's loader, and the code.
std::vector<std::uint8_t> bootable(const Code&, const CodeOptions&);

/// Returns the contents of a transputer's memory with this program when a run begins.
transputer::Image image_of(const Code&, const CodeOptions&);

} // namespace placedpar::occam
