#pragma once

#include "runtime/executive.hpp"
#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/vme_bus.hpp"
#include "runtime/kernel.hpp"

/// What the programs of the thesis's masters spend on input and output over a VMEbus.
namespace placedpar::hardware::bus_programs {

/// A Sun 3/280 at 25 MHz. Published (a table of SGI's): a host's programmed accesses to bytes reach 0.2 to 0.75
/// Mbyte/s, D32 reads about 1 Mbyte/s, writes about 3. Ours, within these ranges: 1.5 us for a byte, 4 us for a word
/// read and 1.33 us for one written, of which the bus takes 310 ns; and a tenth of a millisecond from an interrupt to
/// the process.
constexpr BusProgram sun_3_280{
    .byte_access = Cycles{30}, .read_word = Cycles{92}, .write_word = Cycles{26}, .interrupt = Cycles{2500}};

/// A BBK-V2's T800. Derived from the cycles of its instructions: a turn of the loop that tests a status register, or
/// moves a byte (lb, sb, cj, lend ...), and a block move, whose words go as fast as the bus takes them. An interrupt
/// is a high-priority process that becomes ready.
constexpr BusProgram bbk_v2{.byte_access = Cycles{20},
                            .read_word = instructions::block_move_start,
                            .write_word = instructions::block_move_start,
                            .in_blocks = true};

/// Charges the running process with the cycles of the program, as communication and not as computation.
inline void spend(const Kernel& kernel, Cycles cycles) {
    charge(kernel.running(), [cycles](const OperationCosts&) { return cycles; });
}

/// Cycles in which a bus master swaps the bytes of a word for a host of the other byte order (our choice).
constexpr Cycles conversion{4};

} // namespace placedpar::hardware::bus_programs
