#include "experiments/chapter_3/kit/two_link_plots.hpp"
#include "experiments/chapter_3/kit/two_link_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/record_seeds.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

using Runs = std::vector<SearchRun>;

constexpr std::size_t trials_a_sample = 5;
constexpr std::size_t records_shown = 50; // number of records for the ways of searching that are not judged
constexpr std::size_t lost_for = 20;      // number of samples; this corresponds to 100 of the 600 generations of a
                                          // search

/// Extends a search to 600 generations, well past generation 425, after which the estimates of Figure 3.11 are wrong.
IdentificationWay prolonged(IdentificationWay way) {
    way.usable.count = 120;
    return way;
}

IdentificationWay gated(IdentificationWay way) {
    way.gate.emplace();
    return way;
}

IdentificationWay long_way() { return prolonged(thesis_way()); }

/// A generation, and the known percentage of records in which both compliances are within 10 % in this generation. It
/// was measured earlier, without a gate that stops the search when the motion is steady.
struct Known {
    std::size_t generation;
    double percent;
};
constexpr std::array<Known, 5> looked_at{{{75, 68}, {200, 18}, {350, 2}, {425, 2}, {500, 2}}};

std::string column_of(const Known& each) { return fmt::format("generation {}", each.generation); }

void add_shares(Comparison& comparison, const char* row, const Runs& runs) {
    for (const Known& each : looked_at)
        comparison.add(plain_cell(row, column_of(each), "% of records",
                                  both_within_ten_percent(runs, each.generation, trials_a_sample), 0));
}

/// Compares the simulation with known figures: the shares of records in which both compliances are still within 10 %.
/// In the thesis the compliances become wrong after generation 425.
Comparison share_comparison(const TwoLinkMotion& motion, const Runs& plain, const Seeds& shown) {
    Comparison comparison{
        .name = fmt::format(
            "two links without noise: both within 10 %, while the motion grows steady; {} records in the first row, {} "
            "in the others",
            plain.size(), shown.size()),
        .against = "known"};
    for (const Known& each : looked_at)
        comparison.add(judged_cell("without a gate", column_of(each), "% of records", each.percent,
                                   both_within_ten_percent(plain, each.generation, trials_a_sample),
                                   share_tolerance(each.percent, plain.size()), 0));
    add_shares(comparison, "with the gate", search_many(motion, no_noise, gated(long_way()), shown));
    add_shares(comparison, "elite and Gray code, no gate", search_many(motion, no_noise, prolonged(gray_way()), shown));
    add_shares(comparison, "  and with the gate", search_many(motion, no_noise, gated(prolonged(gray_way())), shown));
    return comparison;
}

/// Compares the ways of searching at low noise. With noise, an elite does not prevent the loss of the right answer.
Comparison low_noise_comparison(const TwoLinkMotion& motion, const Seeds& shown) {
    Comparison comparison{.name = "two links at low noise (2 psi, .003 deg, .1 % of an area): both within 10 %, while "
                                  "the motion grows steady",
                          .against = "known"};
    auto add = [&](const char* row, const IdentificationWay& way) {
        add_shares(comparison, row, search_many(motion, low_noise, way, shown));
    };
    add("without a gate", long_way());
    add("with the gate", gated(long_way()));
    add("elite and Gray code, no gate", prolonged(gray_way()));
    add("  and with the gate", gated(prolonged(gray_way())));
    return comparison;
}

/// Returns the generation in which a search loses the answer: after both compliances were right, one of them is off by
/// more than `percent` from this generation on, for `lost_for` samples in a row. If the search keeps the answer,
/// returns the generation after the last. If the two compliances are never right together, returns nullopt.
std::optional<double> lost_from(const SearchRun& run, double percent) {
    std::size_t off = 0;
    bool found = false;
    for (std::size_t i = 0; i < run.estimates.size(); ++i) {
        bool right = errors_of(run.estimates[i].compliance_in3_per_psi).both_within(percent);
        found |= right;
        off = right || !found ? 0 : off + 1;
        if (off == lost_for)
            return static_cast<double>(trials_a_sample * (i + 2 - lost_for));
    }
    return found ? std::optional(static_cast<double>(trials_a_sample * (run.estimates.size() + 1))) : std::nullopt;
}

/// A way of searching, and bounds for the percentage of its searches that lose the answer before generation 425. The
/// thesis's single run loses the answer at generation 425. If the thesis searched in this way, this percentage is
/// between 2.5 and 97.5 with a probability of 95 %.
struct LosingWay {
    const char* name;
    std::optional<double> at_least, at_most;
    Runs runs;
};

/// Adds the quantiles of the generation in which the searches lose the answer, for one way of searching.
void add_lost(Comparison& comparison, const LosingWay& way, double percent) {
    constexpr double thesis_generation = 425;
    std::string row = fmt::format("{}, off by {} %", way.name, percent);
    std::vector<double> lost;
    for (const SearchRun& run : way.runs)
        if (auto generation = lost_from(run, percent))
            lost.push_back(*generation);
    auto before = std::ranges::count_if(lost, [](double generation) { return generation < thesis_generation; });
    Cell share = share_cell(row, "off before 425 [%]", static_cast<std::size_t>(before), lost.size());
    share.at_least = way.at_least;
    share.at_most = way.at_most;
    comparison.add(plain_cell(row, "searches", "", static_cast<double>(lost.size()), 0));
    for (auto [column, part] : {std::pair("95 % from", 0.025), {"median", 0.5}, {"to", 0.975}})
        comparison.add(plain_cell(row, column, "", quantile(lost, part), 0));
    comparison.add(share);
    comparison.add(plain_cell(row, "from [%]", "", share.interval->low, 1));
    comparison.add(plain_cell(row, "to [%]", "", share.interval->high, 1));
}

/// Judges which ways of searching can have made the thesis's single run.
Comparison single_run_comparison(const TwoLinkMotion& motion, const Runs& plain, const Seeds& seeds) {
    Comparison comparison{
        .name = fmt::format("{} records, no gate: the generation from which one of the two compliances is off for 100 "
                            "generations, of the searches that found both",
                            plain.size()),
        .notes = "585: not before the end of the record. Figure 3.11: both \"start to deviate\" at 425\n",
        .judged = true};
    const LosingWay ways[]{
        {"as the thesis", 2.5, 97.5, plain},
        {"elite and Gray code", {}, 2.5, search_many(motion, no_noise, prolonged(gray_way()), seeds)},
        {"as the thesis, low noise", 97.5, {}, search_many(motion, low_noise, long_way(), seeds)},
        {"elite and Gray code, low noise", 97.5, {}, search_many(motion, low_noise, prolonged(gray_way()), seeds)}};
    for (const LosingWay& way : ways)
        add_lost(comparison, way, 20); // the least error that is visible in the thesis's figure
    add_lost(comparison, {"as the thesis", {}, {}, plain}, 10);
    return comparison;
}

Plot plot_of_loss(const TwoLinkMotion& motion, std::uint64_t seed) {
    const TwoLinkSearch plain = search_two_links(motion, no_noise, long_way(), seed);
    const SearchRun with_gate = search_two_links(motion, no_noise, gated(prolonged(gray_way())), seed).run;
    return plot_of_compliances(plain.prepared, plain.run, with_gate, trials_a_sample);
}

Replay replay_loss_of_excitation(const ReplayContext& context) {
    TwoLinkMotion motion = simulate_two_links();
    Seeds seeds = record_seeds(context.seed, search_records);
    context.progress("600 generations of each record, with and without the gate");
    Runs plain = search_many(motion, no_noise, long_way(), seeds);
    Seeds shown(seeds.begin(), seeds.begin() + records_shown);
    return replay_of({share_comparison(motion, plain, shown), single_run_comparison(motion, plain, seeds),
                      low_noise_comparison(motion, shown)},
                     {{"figure-3-11", plot_of_loss(motion, seeds.front())}});
}

} // namespace

extern const Experiment loss_of_excitation_experiment{
    .name = "loss-of-excitation",
    .about = "how the estimates change when the motion becomes steady",
    .chapter = "3",
    .number = 6,
    .run = replay_loss_of_excitation,
};

} // namespace placedpar
