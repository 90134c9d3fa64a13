#include "experiments/kit/experiment.hpp"
#include "experiments/kit/experiment_runs.hpp"
#include "runtime/fingerprint.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar {

namespace {

/// A line fitted to half the time of a round trip: a message of n words takes `start_us` + `word_us` n microseconds.
struct PingPong {
    double start_us = 0, word_us = 0;
};

/// Runs the ping-pong with messages of one word and of a thousand words.
class PingPongs {
public:
    explicit PingPongs(const ReplayContext& context) : context_(context) {}

    PingPong through(int switches) {
        constexpr int many = 1000;
        double one = half_round_trip_us(1, switches), all = half_round_trip_us(many, switches);
        double word = (all - one) / (many - 1);
        return {one - word, word};
    }

    std::uint64_t fingerprint() const { return fingerprint_.value(); }

private:
    double half_round_trip_us(int words, int switches) {
        constexpr int rounds = 20;
        context_.progress(fmt::format("{} words through {} switches", words, switches));
        RunReport report = run_to_the_end(context_.examples / "machine/poznan" / "ping-pong.cfs",
                                          {{"words", std::to_string(words)},
                                           {"rounds", std::to_string(rounds)},
                                           {"switches", std::to_string(switches)}},
                                          context_);
        fingerprint_.mix(report.result.fingerprint);
        return 1000 * in_milliseconds(report.result.time) / (2 * rounds);
    }

    const ReplayContext& context_;
    Fingerprint fingerprint_;
};

Replay replay_poznan(const ReplayContext& context) {
    PingPongs runs(context);
    PingPong direct = runs.through(0), switched = runs.through(3);
    Comparison comparison{.name = "half a round trip of n words between two T805s",
                          .against = "Poznan",
                          .judged = true,
                          .names_origins = true};
    auto cell = [](const char* row, double known, double simulated, double tolerance, Origin origin) {
        Cell judged = judged_cell(row, "half", "us", known, simulated, tolerance, 2);
        judged.source = "Poznan, 2008 (sarevok/pr)";
        judged.origin = origin;
        return judged;
    };
    comparison.add(cell("half a round trip, to start", 11.0, direct.start_us, 0.2, Origin::calibrated));
    comparison.add(cell("half a round trip, a word", 2.25, direct.word_us, 0.01 * 2.25, Origin::fitted));
    comparison.add(cell("a word through three C004", 4.30, switched.word_us, 0.01 * 4.30, Origin::fitted));
    comparison.notes = "the number of switches between the slower pairs, three, is inferred from their rate\n";
    Replay replay{.comparisons = {comparison}};
    replay.constants =
        "   calibrated to the time to start: 201 cycles for a call of the toolset's ChanIn or ChanOut\n   The link's "
        "constants are those of placedpar replay links, fitted to the time of a word and to other figures.\n";
    replay.fingerprint = runs.fingerprint();
    return replay;
}

} // namespace

extern const Experiment poznan_experiment{
    .name = "poznan",
    .about = "round trips of messages between two T805s, as measured in Poznan in 2008",
    .chapter = "machine",
    .number = 2,
    .run = replay_poznan,
};

} // namespace placedpar
