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

/// Returns where the loader puts the code, in bytes from the start of memory. The vector space is behind it, then comes
/// what the main procedure gets as free memory.
std::uint32_t where_code_is(const Code&, const CodeOptions&);

/// Returns a bootable file that runs the program on one transputer: a loader of ours, and the code.
std::vector<std::uint8_t> bootable(const Code&, const CodeOptions&);

/// Returns the program as it is in the memory of a transputer when a run begins.
transputer::Image image_of(const Code&, const CodeOptions&);

} // namespace placedpar::occam
