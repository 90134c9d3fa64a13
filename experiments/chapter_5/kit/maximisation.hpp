#pragma once

#include "experiments/kit/experiment.hpp"
#include "gaprocs/islands.hpp"
#include "report/convergence.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// A constant objective function and the target of its search: the optimum, or the valley in which it lies.
struct StaticTask {
    std::string problem; ///< name in a netlist
    double target;       ///< objective that ends the search
};
const std::vector<StaticTask>& static_tasks();

/// Returns the number of generations, from 1, until an island reaches the target, or `limit` if no island does. The
/// operators are those of thesis 5.4, but with ranking, since these fitnesses may be negative. There are `islands`
/// islands of `population` individuals each. Neighbours in a hypercube send their best individuals in turn every three
/// generations (5.2.1).
std::size_t generations_to_target(const StaticTask& task, std::size_t islands, std::size_t population,
                                  std::size_t limit, std::uint64_t seed);

/// The time that a task takes, for several sizes of the search and all seeds of a replay.
struct TaskStudy {
    StaticTask task;
    std::vector<std::size_t> sizes;
    double limit = 0;                       ///< value of `taken` if the target is not reached
    std::vector<std::vector<double>> taken; ///< generations or evaluations, by size and seed

    std::size_t reached(std::size_t size) const;
    /// Returns the percentage of the runs that reach the target.
    double reached_percent(std::size_t size) const;
    /// Returns the median over the seeds.
    double median(std::size_t size) const;
};

/// Returns generations_to_target for every seed of the replay.
std::vector<double> study_task(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                               std::size_t population, std::size_t limit);

/// Returns the best objective of all islands so far, generation by generation, for the same runs.
ConvergenceCurve study_convergence(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                                   std::size_t population, std::size_t generations);

/// Plots medians by size, with 95 % intervals, for the sizes with which more than nine in ten runs reach the target.
Panel taken_panel(std::string title, Axis x, Axis y, const std::vector<TaskStudy>& studies);
/// Plots how many runs reach the target, with 95 % intervals.
Panel reached_panel(std::string title, Axis x, const std::vector<TaskStudy>& studies);

} // namespace placedpar
