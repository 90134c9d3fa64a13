#include "experiments/chapter_3/kit/boom_search.hpp"
#include "experiments/kit/claims.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// One of the thesis's two experiments, either without an elite, as in the thesis, or with an elite.
struct FallingSearch {
    const char* name;
    AreasFrom from;
    std::size_t elite;
};
constexpr FallingSearch falling_searches[]{{"1: spool", AreasFrom::spool, 0},
                                           {"1: spool, an elite of one", AreasFrom::spool, 1},
                                           {"2: voltage", AreasFrom::servo, 0},
                                           {"2: voltage, an elite of one", AreasFrom::servo, 1}};

/// Returns the percentage of generations in which the best individual's Error is greater than in the generation before.
/// Also returns the Error of the last generation, divided by the Error of the first generation.
Figures course_of(const BoomData& data, const FallingSearch& search, std::uint64_t seed) {
    IdentificationWay way = rising_way();
    way.search.elite = search.elite;
    BoomModel model = model_of(data, search.from);
    auto samples = usable_of(data, model, way.usable);
    auto generations = watch_search(data, samples, way, seed);
    double rising = 0;
    for (std::size_t i = 1; i < generations.size(); ++i)
        rising += generations[i].best_error_in3_per_s > generations[i - 1].best_error_in3_per_s ? 1 : 0;
    return {100 * rising / static_cast<double>(generations.size() - 1),
            generations.back().best_error_in3_per_s / generations.front().best_error_in3_per_s};
}

/// Tests the claim "the Error was decreasing monotonically", taken to mean "the Error rises in at most 1 % of the
/// generations". The claim is expected to hold only without noise and with an elite.
Comparison falling_claims(const ReplayContext& context, const char* name, const BoomMotion& motion) {
    std::vector<Claim> claims, ends;
    const bool clean = motion.noise.pressure_psi == 0;
    for (const FallingSearch& search : falling_searches) {
        auto runs = run_seeds(context, fmt::format("{}, {}", name, search.name),
                              [&](std::uint64_t seed) { return course_of(measure(motion, seed), search, seed); });
        claims.push_back({fmt::format("generations that rise, {}", search.name),
                          "%",
                          column(runs, 0),
                          {},
                          1,
                          clean && search.elite > 0 ? ClaimVerdict::holds : ClaimVerdict::fails});
        ends.push_back({fmt::format("last Error by first, {}", search.name), "", column(runs, 1), {}, 1});
    }
    claims.insert(claims.end(), ends.begin(), ends.end());
    return claims_comparison(fmt::format("claims, {}", name), claims);
}

Replay replay_falling_error(const ReplayContext& context) {
    return replay_of({falling_claims(context, "simple plant, no noise", {BoomPlant::simple, no_noise}),
                      falling_claims(context, "simple plant, low noise", {BoomPlant::simple, low_noise}),
                      falling_claims(context, "measured machine, mid noise", {BoomPlant::measured, mid_noise})},
                     {});
}

} // namespace

extern const Experiment falling_error_experiment{
    .name = "falling-error",
    .about = "whether the Error of a search falls monotonically (3.1.3)",
    .chapter = "3",
    .number = 12,
    .run = replay_falling_error,
    .seeds = 60,
};

} // namespace placedpar
