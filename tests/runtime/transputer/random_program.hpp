#pragma once

#include "plain_transputer.hpp"

#include <cstdint>
#include <string>

namespace placedpar::test {

/// What a random program may contain.
struct RandomCodeKind {
    PlainModel model = t800;
    bool processes = true;  ///< several processes of both priorities, channels, alternations, timers
    bool data_first = true; ///< workspaces and data come first in memory, so on the chip; otherwise the code
    int elements = 12;      ///< the number of pieces of each process
};

/// A program that a seed decides. It uses 64 Kbyte of memory, ends with no process ready, and never depends on a value
/// that the reference leaves open.
struct RandomCode {
    std::string source;   ///< for the assembler
    std::uint32_t origin; ///< address of its first byte and instruction
    std::uint32_t workspace;
};

RandomCode random_code(std::uint64_t seed, const RandomCodeKind&);

} // namespace placedpar::test
