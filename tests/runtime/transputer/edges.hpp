#pragma once

#include <cstdint>
#include <vector>

namespace placedpar::test {

/// Returns operands at which the behaviour of instructions may change, and some other operands.
inline std::vector<std::uint32_t> edges() {
    std::vector<std::uint32_t> values{0,          0x7FFFFFFF, 0x80000000, 0x80000001,
                                      0xFFFFFFFE, 0xFFFFFFFF, 0x12345678, 0xDEADBEEF};
    for (const int bit : {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 15, 16, 23, 24, 30})
        for (const int off : {-1, 0, 1})
            values.insert(values.end(), {(1U << bit) + static_cast<std::uint32_t>(off),
                                         -(1U << bit) - static_cast<std::uint32_t>(off)});
    return values;
}

} // namespace placedpar::test
