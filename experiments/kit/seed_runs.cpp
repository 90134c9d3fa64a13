#include "experiments/kit/seed_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <optional>
#include <thread>

namespace placedpar {

namespace {

using Run = std::function<Figures(std::uint64_t seed)>;

std::optional<Figures> kept(const ReplayContext& context, const std::string& what, std::uint64_t seed) {
    return context.kept ? context.kept->find(what, seed) : std::nullopt;
}

/// As many runs at once as there are seeds; they have ended when it returns or throws.
std::vector<Figures> run_at_once(std::span<const std::uint64_t> seeds, const Run& run) {
    std::vector<std::future<Figures>> under_way;
    for (std::uint64_t seed : seeds)
        under_way.push_back(std::async(std::launch::async, run, seed));
    std::vector<Figures> figures;
    for (std::future<Figures>& each : under_way)
        figures.push_back(each.get());
    return figures;
}

} // namespace

Seeds seeds_of(const ReplayContext& context) { return record_seeds(context.seed, context.seeds); }

std::vector<Figures> run_seeds(const ReplayContext& context, const std::string& what, const Run& run) {
    const std::size_t at_once = std::max(std::thread::hardware_concurrency(), 1u);
    Seeds seeds = seeds_of(context), missing;
    for (std::uint64_t seed : seeds)
        if (!kept(context, what, seed))
            missing.push_back(seed);
    std::map<std::uint64_t, Figures> made;
    for (std::size_t first = 0; first < missing.size(); first += at_once) {
        context.progress(fmt::format("{}: {} of {} seeds", what, seeds.size() - missing.size() + first, seeds.size()));
        auto part = std::span(missing).subspan(first, std::min(at_once, missing.size() - first));
        std::vector<Figures> figures = run_at_once(part, run);
        for (std::size_t i = 0; i < part.size(); ++i) {
            made[part[i]] = figures[i];
            if (context.kept)
                context.kept->add(what, part[i], figures[i]);
        }
    }
    std::vector<Figures> all;
    for (std::uint64_t seed : seeds)
        all.push_back(made.contains(seed) ? made[seed] : *kept(context, what, seed));
    return all;
}

std::vector<double> column(const std::vector<Figures>& runs, std::size_t index) {
    std::vector<double> values;
    for (const Figures& figures : runs)
        values.push_back(figures[index]);
    return values;
}

} // namespace placedpar
