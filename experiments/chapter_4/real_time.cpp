#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// A machine of 1991, or what Wan expected of the next years.
struct Proposal {
    const char* what;
    Overrides overrides;
    std::optional<double> thesis_rate = {}; ///< Table 4.2: generations a second
};

/// The master's part of a slave's share with n slaves: alpha is 14400 / 1750 cycles.
std::string share_beside_pipeline(int slaves) {
    double alpha = 14400.0 / 1750;
    return fmt::format("{:.4f}", std::max(0.0, (alpha - slaves) / (alpha + 1)));
}

Overrides pipelined(int islands, int slaves) {
    return {{"islands", std::to_string(islands)},
            {"sharing", "2"},
            {"slaves", std::to_string(slaves)},
            {"own_share", share_beside_pipeline(slaves)}};
}

std::vector<Proposal> proposals() {
    return {
        {"1 T800, the traditional algorithm", {{"islands", "1"}, {"slaves", "0"}}, 9.8},
        {"16 T800: 4 islands of 30, 3 slaves each", {}, 117.6},
        {"16 T800: occam's channels, no library", {{"calls", "0"}}},
        {"16 T800: slaves on two links of each master", {{"chains", "2"}}},
        {"16 T800: in pairs that share 7 slaves", pipelined(4, 7)},
        {"16 T800: 8 islands of 15, in pairs that share 3", pipelined(8, 3)},
        {"16 T800: 8 islands of 15, one slave each", {{"islands", "8"}, {"slaves", "1"}}},
        {"16 T800: 16 islands of 8", {{"islands", "16"}, {"slaves", "0"}, {"individuals", "128"}}},
        {"32 T800: 4 islands of 30, 7 slaves each", {{"slaves", "7"}}},
        {"32 T800: on two links of each master", {{"slaves", "7"}, {"chains", "2"}}},
        {"32 T800: 8 islands of 15, 3 slaves each", {{"islands", "8"}}},
        {"64 T800: 4 islands of 30, 15 slaves each", {{"slaves", "15"}, {"chains", "2"}}},
        {"64 T800: 8 islands of 15, 7 slaves each", {{"islands", "8"}, {"slaves", "7"}}},
        {"64 T800: 8 islands, 7 slaves, occam's channels", {{"islands", "8"}, {"slaves", "7"}, {"calls", "0"}}},
        {"16 processors ten times as fast, T800 links", {{"clock", "200000000"}}},
        {"4 processors ten times as fast, 4 islands", {{"clock", "200000000"}, {"slaves", "0"}}},
        {"1 processor ten times as fast", {{"clock", "200000000"}, {"islands", "1"}, {"slaves", "0"}}},
    };
}

constexpr double whole_transient_s = .4;
constexpr int generations_of_transient = 20 * 5; // equation 4.15: samples and trials

Replay replay_real_time(const ReplayContext& context) {
    Comparison comparison{.name = "Section 4.4: a transient of 0.4 s has 20 samples, 5 generations each"};
    Fingerprint fingerprint;
    std::string in_time;
    for (const Proposal& each : proposals()) {
        context.progress(each.what);
        RunReport report =
            run_to_the_end(context.examples / "66-architectures" / "architecture.cfs", each.overrides, context);
        fingerprint.mix(report.result.fingerprint);
        double seconds = generations_of_transient / report.measured("island[0]", "generations_per_second");
        auto thesis_s = each.thesis_rate ? std::optional(generations_of_transient / *each.thesis_rate) : std::nullopt;
        comparison.add(cell_of(each.what, "time", "s", thesis_s, seconds,
                               thesis_s ? std::optional(.06 * *thesis_s) : std::nullopt, 3));
        if (seconds <= whole_transient_s)
            in_time += fmt::format("{}{}", in_time.empty() ? "" : "; ", each.what);
    }
    comparison.notes = fmt::format("in time: {}\n", in_time);
    return {.comparisons = {comparison},
            .constants = "   Workload, calibration and published constants are those of table-e1.\n",
            .fingerprint = fingerprint.value()};
}

} // namespace

extern const Experiment real_time_experiment{
    .name = "real-time",
    .about = "which machine would have identified a transient while it lasts",
    .chapter = "4",
    .number = 3,
    .run = replay_real_time,
};

} // namespace placedpar
