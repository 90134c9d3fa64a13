#pragma once

#include <chrono>

namespace placedpar::monitor {

/// Returns this computer's time in seconds since 1970, rounded down to 1 ms. The time is only for people to read; no
/// decision depends on it.
inline double now_at() {
    auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
    return static_cast<double>(std::chrono::duration_cast<std::chrono::milliseconds>(since_1970).count()) / 1000;
}

} // namespace placedpar::monitor
