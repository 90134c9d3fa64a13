#include "experiments/chapter_4/kit/parallel_identification.hpp"

namespace placedpar {

namespace {

Replay replay_figure_4_9(const ReplayContext& context) {
    return replay_parallel_identification(
        context, {"figure-4-9", "Figure 4.9: experiment 1 on 16 T800s, areas from the measured spool",
                  hydraulics::AreasFrom::spool});
}

} // namespace

extern const Experiment figure_4_9_experiment{
    .name = "figure-4-9",
    .about = "the boom's compliance identified on 16 transputers from the measured spool",
    .chapter = "4",
    .number = 4,
    .run = replay_figure_4_9,
    .seeds = 100,
};

} // namespace placedpar
