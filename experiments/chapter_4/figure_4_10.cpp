#include "experiments/chapter_4/kit/parallel_identification.hpp"

namespace placedpar {

namespace {

Replay replay_figure_4_10(const ReplayContext& context) {
    return replay_parallel_identification(
        context, {"figure-4-10", "Figure 4.10: experiment 2 on 16 T800s, areas from the servo-valve's voltage",
                  hydraulics::AreasFrom::servo});
}

} // namespace

extern const Experiment figure_4_10_experiment{
    .name = "figure-4-10",
    .about = "the boom's compliance identified on 16 transputers from the servo-valve's voltage",
    .chapter = "4",
    .number = 5,
    .run = replay_figure_4_10,
    .seeds = 100,
};

} // namespace placedpar
