#include "explore/runs_at_once.hpp"

#include <algorithm>
#include <atomic>
#include <vector>

namespace placedpar {

void run_at_once(std::size_t pieces, const std::function<void(std::size_t, Interruption&)>& work,
                 const Interruption& interruption, const std::function<void(std::size_t)>& done, std::size_t at_once) {
    std::vector<Interruption> interruptions(std::min(pieces, at_once));
    std::atomic<std::size_t> next{0}, ended{0};
    auto run = [&](std::size_t worker) {
        Interruption& own = interruptions[worker];
        for (std::size_t piece; !interruption.requested() && (piece = next++) < pieces; ++ended)
            work(piece, own);
    };
    on_workers(interruptions.size(), run, [&] {
        if (interruption.requested())
            std::ranges::for_each(interruptions, &Interruption::request);
        done(ended);
    });
}

} // namespace placedpar
