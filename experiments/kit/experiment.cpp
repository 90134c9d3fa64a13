#include "experiments/kit/experiment.hpp"

#include "runtime/fingerprint.hpp"

#include <algorithm>
#include <tuple>

namespace placedpar {

Replay replay_of(std::vector<Comparison> comparisons, std::vector<NamedPlot> plots) {
    Fingerprint fingerprint;
    for (const Comparison& comparison : comparisons)
        for (char character : print_comparison(comparison))
            fingerprint.mix(static_cast<unsigned char>(character));
    return {.comparisons = std::move(comparisons), .fingerprint = fingerprint.value(), .plots = std::move(plots)};
}

std::vector<Experiment> in_order(std::vector<Experiment> experiments) {
    std::ranges::sort(experiments, {}, [](const Experiment& each) { return std::tuple(each.chapter, each.number); });
    return experiments;
}

} // namespace placedpar
