#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

namespace placedpar {

/// As many as the machine has; at least 1.
std::size_t count_cores();

/// Calls work(0), work(1) and so on, each in a thread of its own, and returns when all are done. Meanwhile calls
/// `meanwhile` every so often in the thread of the caller. What work throws is thrown again in the end, the first
/// worker's first; what meanwhile throws, as soon as all are done.
void on_workers(
    std::size_t workers, const std::function<void(std::size_t)>& work, const std::function<void()>& meanwhile = [] {},
    std::chrono::milliseconds often = std::chrono::milliseconds(100));

} // namespace placedpar
