#include "explore/workers.hpp"

#include "text/texts_in_memory.hpp"

#include <algorithm>
#include <future>
#include <optional>
#include <thread>
#include <vector>

namespace placedpar {

std::size_t count_cores() { return std::max(std::thread::hardware_concurrency(), 1U); }

void on_workers(std::size_t workers, const std::function<void(std::size_t)>& work,
                const std::function<void()>& meanwhile, std::chrono::milliseconds often) {
    std::vector<std::future<void>> running; // the destructor of a future waits for its thread
    const TextsInMemory* texts = texts_of_this_thread();
    const auto work_with_texts = [&work, texts](std::size_t worker) {
        std::optional<ReadsFromMemory> reading;
        if (texts)
            reading.emplace(*texts);
        work(worker);
    };
    for (std::size_t i = 0; i < workers; ++i)
        running.push_back(std::async(std::launch::async, work_with_texts, i));
    for (std::future<void>& each : running)
        while (each.wait_for(often) != std::future_status::ready)
            meanwhile();
    for (std::future<void>& each : running)
        each.get();
}

} // namespace placedpar
