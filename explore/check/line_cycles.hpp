#pragma once

#include "occam/language/tree.hpp"
#include "runtime/transputer/model.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace placedpar {

/// The number of instructions that the compiler makes for a line of occam, and their cycles, which editors show beside
/// the line. Each instruction counts once, with code and data in the chip's memory, as in `placedpar disassemble`.
struct LineCycles {
    std::size_t instructions = 0;
    unsigned least = 0, most = 0;
    bool is_open = false; ///< the time of some instruction depends on the length of a message
};

/// Compiles all procedures of the main file. Returns the cycles of each line; nothing if the compiler refuses the file.
/// REQUIRES: the program was checked without errors.
std::map<std::size_t, LineCycles> cycles_of_lines(const occam::Program&, std::vector<std::filesystem::path> folders,
                                                  transputer::Model);

/// Returns a sentence such as "7 instructions, 20 to 35 cycles on a T800".
std::string text_of_cycles(const LineCycles&, transputer::Model);

} // namespace placedpar
