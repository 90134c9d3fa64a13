#pragma once

#include "runtime/transputer/model.hpp"

#include <cstdint>
#include <vector>

namespace placedpar::transputer {

/// A program that is in the memory of a transputer when the run begins.
struct Image {
    std::vector<std::uint8_t> code;
    Word offset = 0; ///< of the code, from the start of memory
    /// Instructions that begin the program. They are executed as those are that a link has brought at a boot.
    std::vector<std::uint8_t> start;
    /// The first process ends with `stopp` in front of `end`, with this workspace. Both count from the start of memory.
    Word end = 0, workspace = 0;
    std::uint64_t bytes = 0; ///< of memory that the program needs, from the start of memory
};

} // namespace placedpar::transputer
