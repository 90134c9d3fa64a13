#pragma once

#include "runtime/executive.hpp"
#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/kernel.hpp"

/// What input and output over a VMEbus cost the two bus masters of the thesis: the host computer and a transputer
/// board.
namespace placedpar::hardware::bus_programs {

/// The program of the host, a Sun 3/280 at 25 MHz. A table of SGI's states what a host's programmed accesses reach: 0.2
/// to 0.75 Mbyte/s for bytes, about 1 Mbyte/s for D32 reads, and about 3 Mbyte/s for D32 writes. Our choice within
/// these ranges: 1.5 us for a byte, 4 us for reading a word, and 1.33 us for writing a word, each including 310 ns on
/// the bus. Also our choice: 0.1 ms from an interrupt to the process.
constexpr BusProgram sun_3_280{
    .byte_access = Cycles{30}, .read_word = Cycles{92}, .write_word = Cycles{26}, .interrupt = Cycles{2500}};

/// The program of the T800 on a transputer board BBK-V2. The figures are derived from the cycles of its instructions. A
/// byte costs one pass of a loop that tests a status register or moves a byte (lb, sb, cj, lend ...). A block move
/// moves words as fast as the bus takes them. An interrupt makes a high-priority process ready, at no further cost.
constexpr BusProgram bbk_v2{.byte_access = Cycles{20},
                            .read_word = instructions::block_move_start,
                            .write_word = instructions::block_move_start,
                            .in_blocks = true};

/// Makes the running process compute for these cycles.
inline void spend(const Kernel& kernel, Cycles cycles) {
    charge(kernel.running(), [cycles](const OperationCosts&) { return cycles; });
}

/// The cycles in which a transputer swaps the bytes of a word for a host of the other byte order (our choice).
constexpr Cycles conversion{4};

} // namespace placedpar::hardware::bus_programs
