#include "workbench/runs_at_once.hpp"

#include "workbench/workers.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace placedpar {

namespace {

constexpr std::chrono::milliseconds between_looks{10};

/// Counts itself out, also when an exception ends its work.
class Running {
public:
    explicit Running(std::atomic<std::size_t>& running) : running_(running) {}
    ~Running() { --running_; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

private:
    std::atomic<std::size_t>& running_;
};

} // namespace

void run_at_once(std::size_t pieces, const std::function<void(std::size_t, Interruption&)>& work,
                 const Interruption& interruption, const std::function<void(std::size_t)>& done) {
    const std::size_t workers = std::min(pieces, count_cores());
    std::vector<Interruption> interruptions(workers);
    std::atomic<std::size_t> next{0}, ended{0}, running{workers};
    auto run = [&](Interruption& own) {
        Running until_it_ends(running);
        for (std::size_t piece; !own.requested() && (piece = next++) < pieces; ++ended)
            work(piece, own);
    };
    auto watch = [&] {
        for (; running > 0; std::this_thread::sleep_for(between_looks)) {
            if (interruption.requested())
                std::ranges::for_each(interruptions, &Interruption::request);
            done(ended);
        }
    };
    on_workers(workers + 1, [&](std::size_t i) { i < workers ? run(interruptions[i]) : watch(); });
}

} // namespace placedpar
