#include "runtime/time.hpp"

#include <fmt/format.h>

namespace placedpar {

std::string to_string(Time t) {
    auto count = static_cast<double>(t.count());
    if (t >= std::chrono::seconds{1})
        return fmt::format("{:.6f} s", count * 1e-12);
    if (t >= std::chrono::milliseconds{1})
        return fmt::format("{:.6f} ms", count * 1e-9);
    if (t >= std::chrono::microseconds{1})
        return fmt::format("{:.6f} us", count * 1e-6);
    if (t >= std::chrono::nanoseconds{1})
        return fmt::format("{:.3f} ns", count * 1e-3);
    return fmt::format("{} ps", t.count());
}

} // namespace placedpar
