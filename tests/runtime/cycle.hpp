#pragma once

#include <chrono>

namespace placedpar::test {

/// A cycle of a processor at 20 MHz, the usual clock of a simulation.
inline constexpr std::chrono::nanoseconds cycle{50};

} // namespace placedpar::test
