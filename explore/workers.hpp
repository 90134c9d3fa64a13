#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

namespace placedpar {

/// Returns the number of cores of the machine; at least 1.
std::size_t count_cores();

/// Calls work(0), work(1) and so on, each in its own thread, and returns when all of them have ended. Meanwhile, calls
/// `meanwhile` at intervals of `often` in the caller's thread. If several workers throw exceptions, rethrows the
/// exception of the worker with the lowest number. The threads read the same texts in memory as the caller's thread
/// (text/texts_in_memory.hpp).
void on_workers(
    std::size_t workers, const std::function<void(std::size_t)>& work, const std::function<void()>& meanwhile = [] {},
    std::chrono::milliseconds often = std::chrono::milliseconds(100));

} // namespace placedpar
