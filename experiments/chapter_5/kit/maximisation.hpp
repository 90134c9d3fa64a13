#pragma once

#include "experiments/kit/experiment.hpp"
#include "gaprocs/islands.hpp"
#include "report/convergence.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// A function that stands still, and what is to be reached of it: the optimum, or the valley that it lies in.
struct StaticTask {
    std::string problem; ///< as a netlist names it
    double target;       ///< objective that is good enough
};
const std::vector<StaticTask>& static_tasks();

/// Generations until one of the islands reaches the target first, from 1; `limit` where none does before. Operators as
/// in 5.4, but ranking, since these fitnesses may be negative: islands of `population` each, the hypercube's neighbours
/// sending their bests in turn every three generations (5.2.1).
std::size_t generations_to_target(const StaticTask& task, std::size_t islands, std::size_t population,
                                  std::size_t limit, std::uint64_t seed);

/// How long a task takes by the size of something, over the seeds of a replay.
struct TaskStudy {
    StaticTask task;
    std::vector<std::size_t> sizes;
    double limit = 0;                       ///< `taken` where the target is not reached
    std::vector<std::vector<double>> taken; ///< of each size, of each seed: generations or evaluations

    std::size_t reached(std::size_t size) const;
    /// Share of the runs, in percent.
    double reached_percent(std::size_t size) const;
    /// The median over the seeds.
    double median(std::size_t size) const;
};

/// generations_to_target of every seed of the replay.
std::vector<double> study_task(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                               std::size_t population, std::size_t limit);

/// The best objective of all islands so far, generation by generation, of the same runs.
ConvergenceCurve study_convergence(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                                   std::size_t population, std::size_t generations);

/// Medians by size with their 95 % intervals; of sizes with which more than nine in ten runs reach the target.
Panel taken_panel(std::string title, Axis x, Axis y, const std::vector<TaskStudy>& studies);
/// How many runs reach the target, with 95 % intervals.
Panel reached_panel(std::string title, Axis x, const std::vector<TaskStudy>& studies);

} // namespace placedpar
