#include "experiments/kit/study_replay.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar {

namespace {

constexpr double whole_transient_s = .4;

Replay replay_real_time(const ReplayContext& context) {
    const StudyReplay study(context, "explore/architectures/real-time.toml");
    Replay replay = study.replay();
    Comparison& times = study.table(replay, "Section 4.4: a transient of 0.4 s has 20 samples, 5 generations each");
    std::string in_time;
    for (const Cell& cell : times.cells)
        if (cell.simulated <= whole_transient_s)
            in_time += (in_time.empty() ? "" : "; ") + cell.row;
    times.notes = fmt::format("in time: {}\n", in_time);
    return replay;
}

} // namespace

extern const Experiment real_time_experiment{
    .name = "real-time",
    .about = "machines that could identify a transient while it lasts",
    .chapter = "4",
    .number = 3,
    .run = replay_real_time,
};

} // namespace placedpar
