#pragma once

#include "runtime/executive.hpp"
#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/kernel.hpp"

/// The costs of input and output over a VMEbus in the programs of the thesis's masters.
namespace placedpar::hardware::bus_programs {

/// The program of a Sun 3/280 at 25 MHz. Published (a table of SGI's): a host's programmed accesses to bytes reach 0.2
/// to 0.75 Mbyte/s, D32 reads about 1 Mbyte/s, and D32 writes about 3 Mbyte/s. Our choice within these ranges: 1.5 us
/// for a byte, 4 us for reading a word, and 1.33 us for writing a word, each including 310 ns on the bus. Also our
/// choice: 0.1 ms from an interrupt to the process.
constexpr BusProgram sun_3_280{
    .byte_access = Cycles{30}, .read_word = Cycles{92}, .write_word = Cycles{26}, .interrupt = Cycles{2500}};

/// The program of a BBK-V2's T800. The figures are derived from the cycles of its instructions. A byte costs one pass
/// of a loop that tests a status register or moves a byte (lb, sb, cj, lend ...). Words are moved by a block move, as
/// fast as the bus takes them. An interrupt is a high-priority process that becomes ready.
constexpr BusProgram bbk_v2{.byte_access = Cycles{20},
                            .read_word = instructions::block_move_start,
                            .write_word = instructions::block_move_start,
                            .in_blocks = true};

/// Charges the running process for the cycles of the program. These cycles count as communication, not as computation.
inline void spend(const Kernel& kernel, Cycles cycles) {
    charge(kernel.running(), [cycles](const OperationCosts&) { return cycles; });
}

/// The cycles in which a bus master swaps the bytes of a word for a host of the other byte order (our choice).
constexpr Cycles conversion{4};

} // namespace placedpar::hardware::bus_programs
