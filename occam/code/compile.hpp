#pragma once

#include "occam/code/code.hpp"
#include "runtime/transputer/image.hpp"

#include <cstdint>
#include <vector>

namespace placedpar::occam {

/// The free memory that a main procedure receives as its parameter `[]INT memory` has this size.
inline constexpr std::int64_t bytes_of_free_memory = 256 * 1024;

/// Compiles a program that was checked without errors. Throws RefusedText if the program has a construct that this
/// compiler does not support.
Code compile(const Program&, const Declaration& main, const CodeOptions&);

/// Returns the address to which the loader moves the code, in bytes from the start of memory. The code is followed by
/// the vector space, then by the main procedure's free memory.
std::uint32_t where_code_is(const Code&, const CodeOptions&);

/// Returns a bootable file that runs the program on one transputer. The file has PlacedPar's loader, then the code.
std::vector<std::uint8_t> bootable(const Code&, const CodeOptions&);

/// Returns what is in the memory of a transputer when a run of this program begins.
transputer::Image image_of(const Code&, const CodeOptions&);

} // namespace placedpar::occam
