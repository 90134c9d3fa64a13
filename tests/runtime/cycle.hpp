#pragma once

#include <chrono>

namespace placedpar::test {

/// Of a processor at 20 MHz, which is what a simulation gives when it is not told otherwise.
inline constexpr std::chrono::nanoseconds cycle{50};

} // namespace placedpar::test
