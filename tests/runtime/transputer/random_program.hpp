#pragma once

#include "plain_transputer.hpp"

#include <cstdint>
#include <string>

namespace placedpar::test {

/// States what a random program may contain.
struct RandomCodeKind {
    PlainModel model = t800;
    bool processes = true;  ///< several processes of both priorities, channels, alternations, timers
    bool data_first = true; ///< true: workspaces and data are first in memory, and so on the chip; false: the code is
                            ///< first
    int elements = 12;      ///< number of pieces of each process
};

/// A program that a seed determines. It uses 64 Kbyte of memory, ends with no process ready, and never depends on a
/// value that the reference leaves open.
struct RandomCode {
    std::string source;   ///< for the assembler
    std::uint32_t origin; ///< address of its first byte and instruction
    std::uint32_t workspace;
};

RandomCode random_code(std::uint64_t seed, const RandomCodeKind&);

} // namespace placedpar::test
