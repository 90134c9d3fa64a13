#pragma once

#include <chrono>

namespace placedpar::test {

/// The length of a cycle at 20 MHz, the usual clock frequency of a processor.
inline constexpr std::chrono::nanoseconds cycle{50};

} // namespace placedpar::test
