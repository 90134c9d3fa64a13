#include "runtime/vector_width.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace placedpar {

namespace {

std::atomic<std::size_t>& width_in_use() {
    static std::atomic<std::size_t> width = widest_vector_width();
    return width;
}

} // namespace

std::size_t widest_vector_width() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw"))
        return 8;
    if (__builtin_cpu_supports("avx2"))
        return 4;
#endif
    return 2;
}

std::size_t vector_width() { return width_in_use().load(std::memory_order_relaxed); }

void use_vector_width(std::size_t width) {
    if (std::ranges::find(vector_widths, width) == vector_widths.end() || width > widest_vector_width())
        throw std::invalid_argument(fmt::format(
            "a vector width of {} doubles, expected 2, 4 or 8, and at most {}, the widest that this processor has",
            width, widest_vector_width()));
    width_in_use() = width;
}

} // namespace placedpar
