#include "app/experiment.hpp"
#include "app/single_link/cells.hpp"
#include "app/two_links/two_link_plots.hpp"
#include "app/two_links/two_link_study.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

IdentificationWay long_way() {
    IdentificationWay way = thesis_way();
    way.usable.count = 120; // 600 generations: well past the 425 of Figure 3.11
    return way;
}

IdentificationWay gated_way() {
    IdentificationWay way = long_way();
    way.gate.emplace();
    return way;
}

/// The share of seeds that is still right, which the thesis saw falling after generation 425.
Reading share_reading(const TwoLinkMotion& motion, std::uint64_t seed) {
    struct Known {
        std::size_t generation;
        double percent, tolerance;
    };
    constexpr std::array<Known, 5> known{{{75, 68, 15}, {200, 18, 15}, {350, 2, 10}, {425, 2, 10}, {500, 2, 10}}};
    Reading reading{
        fmt::format("two links without noise, {} seeds: both within 10 %, while the motion grows steady", search_seeds),
        {},
        "",
        "known"};
    auto plain = search_many(motion, no_noise, long_way(), search_seeds, seed);
    auto gated = search_many(motion, no_noise, gated_way(), search_seeds, seed);
    for (const Known& each : known) {
        std::string column = fmt::format("generation {}", each.generation);
        reading.cells.push_back(judged_cell("without a gate", column, "% of seeds", each.percent,
                                            both_within_ten_percent(plain, each.generation, 5), each.tolerance, 0));
        reading.cells.push_back(
            plain_cell("with the gate", column, "% of seeds", both_within_ten_percent(gated, each.generation, 5), 0));
    }
    return reading;
}

/// From which generation on an estimate is never again within 10 %; the number of generations if it always is.
double lost_after(const SearchRun& run) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < run.estimates.size(); ++i)
        if (errors_of(run.estimates[i].compliance_in3_per_psi).both_within(10))
            last = i + 1;
    return static_cast<double>(5 * last);
}

Reading single_run_reading(const TwoLinkMotion& motion, std::uint64_t seed) {
    Reading reading{
        fmt::format("the generation after which a search is never again right in both, of {} seeds", search_seeds),
        {},
        "the thesis's figure is an eye's reading of one run: both \"start to deviate\" at 425\n",
        "thesis",
        true};
    std::vector<double> lost;
    for (const SearchRun& run : search_many(motion, no_noise, long_way(), search_seeds, seed))
        lost.push_back(lost_after(run));
    reading.cells.push_back(judged_cell("lost after", "median", "generation", 425, median(lost), 200, 0));
    reading.cells.push_back(plain_cell("lost after", "first of 10", "generation", share_below(lost, 0.1), 0));
    reading.cells.push_back(plain_cell("lost after", "last of 10", "generation", share_below(lost, 0.9), 0));
    return reading;
}

} // namespace

Replay replay_loss_of_excitation(const ReplayContext& context) {
    TwoLinkMotion motion = simulate_two_links();
    Replay replay;
    context.progress("600 generations of 50 seeds, with and without the gate");
    replay.readings = {share_reading(motion, context.seed), single_run_reading(motion, context.seed)};
    IdentificationWay way = long_way();
    RecordProblem prepared = measure_two_links(motion, no_noise, way, context.seed);
    SearchRun run = search_transient(prepared.problem, prepared.samples, way, RandomStream(context.seed, "master"));
    replay.plots = {{"figure-3-11", plot_of_compliances(prepared, run, way.search.window.trials)}};
    replay.fingerprint = fingerprint_of(replay.readings);
    return replay;
}

} // namespace placedpar
