#pragma once

#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar {

class ProcessEnvironment;

/// The computing costs of a search or slave on the simulated machine, and the sizes of its messages, as the netlist
/// states them.
struct Workload {
    Cycles error_evaluation{};       ///< cost for one individual and one sample
    Cycles genetic_operators{};      ///< cost of reproduction, crossover and mutation for one individual
    Cycles measurement_conversion{}; ///< cost of preparing one word of the measurements for a slave
    std::uint32_t string_bytes = 0;
    std::uint32_t fitness_bytes = 0;
    std::uint32_t measurement_bytes = 0;
};

/// Returns the number of cycles for copying `bytes` bytes from external memory to external memory. Each word of 4 bytes
/// is read and written. At 20 MHz this gives 13.3 Mbyte/s (T800 databook).
constexpr Cycles block_move(std::uint32_t bytes) {
    const std::int64_t words = (std::int64_t{bytes} + 3) / 4;
    return hardware::instructions::block_move_start + 2 * words * hardware::Memory::outside;
}

} // namespace placedpar
