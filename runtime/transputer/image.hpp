#pragma once

#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace placedpar::transputer {

class CodeLines; // runtime/transputer/code_lines.hpp

/// A program that is in the memory of a transputer when the run begins.
struct Image {
    std::vector<std::uint8_t> code;
    Word offset = 0; ///< offset of the code from the start of memory
    /// Instructions that start the program. They are executed like instructions that a link has loaded at a boot.
    std::vector<std::uint8_t> start;
    /// The program's first process ends at the `stopp` just before the offset `end`, with its workspace at the offset
    /// `workspace`. By these offsets from the start of memory, the end of the program is recognised.
    Word end = 0, workspace = 0;
    std::uint64_t bytes = 0;                          ///< memory that the program needs, from the start of memory
    std::shared_ptr<const CodeLines> lines = nullptr; ///< source lines and procedures of the code; null: unknown
};

} // namespace placedpar::transputer
