#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// A time as the thesis prints it, rounded to its last digit.
struct PrintedTime {
    double s, half_digit_s;
};

/// A machine of 1991, or what Wan expected of the next years.
struct Proposal {
    const char* what;
    Overrides overrides;
    std::optional<PrintedTime> thesis = {}; ///< equations 4.15 and 4.16
};

std::vector<Proposal> proposals() {
    return {
        {"1 T800, the traditional algorithm", {{"processors", "1"}, {"islands", "1"}}, PrintedTime{10, .5}},
        {"16 T800: 4 islands of 30, 3 slaves each", {}, PrintedTime{.8, .05}},
        {"16 T800: occam's channels, no library", {{"calls", "0"}}},
        {"16 T800: slaves on two links of each master", {{"chains", "2"}}},
        {"16 T800: in pairs that share 7 slaves", {{"sharing", "2"}}},
        {"16 T800: 8 islands of 15, in pairs that share 3", {{"islands", "8"}, {"sharing", "2"}}},
        {"16 T800: 8 islands of 15, one slave each", {{"islands", "8"}}},
        {"16 T800: 16 islands of 8", {{"architecture", "hypercube"}}},
        {"32 T800: 4 islands of 30, 7 slaves each", {{"processors", "32"}}},
        {"32 T800: on two links of each master", {{"processors", "32"}, {"chains", "2"}}},
        {"32 T800: 8 islands of 15, 3 slaves each", {{"processors", "32"}, {"islands", "8"}}},
        {"64 T800: on two links of each master", {{"processors", "64"}, {"chains", "2"}}},
        {"64 T800: 8 islands of 15, 7 slaves each", {{"processors", "64"}, {"islands", "8"}}},
        {"64 T800: 8 islands, 7 slaves, occam's channels", {{"processors", "64"}, {"islands", "8"}, {"calls", "0"}}},
        {"16 processors ten times as fast, T800 links", {{"clock", "200M"}}},
        {"4 processors ten times as fast, 4 islands", {{"clock", "200M"}, {"processors", "4"}}},
        {"1 processor ten times as fast", {{"clock", "200M"}, {"processors", "1"}, {"islands", "1"}}},
    };
}

/// Beside the rounding, the rates of Table E.2 that the printed times are computed from are up to 6 % from the times of
/// Table E.1.
Cell time_cell(const Proposal& proposal, double seconds) {
    const auto& thesis = proposal.thesis;
    return cell_of(proposal.what, "time", "s", thesis ? std::optional(thesis->s) : std::nullopt, seconds,
                   thesis ? std::optional(thesis->half_digit_s + .06 * thesis->s) : std::nullopt, 3);
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
        comparison.add(time_cell(each, seconds));
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
