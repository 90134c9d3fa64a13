#pragma once

#include "experiments/kit/experiment.hpp"
#include "gaprocs/islands.hpp"
#include "report/convergence.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

/// An objective function that does not change during the search, and the value at which the search ends. This value is
/// the optimum, or a value that is reached only in the basin of the optimum.
struct StaticTask {
    std::string problem; ///< name in a netlist
    double target;       ///< the search ends at this objective, or a better one
};
const std::vector<StaticTask>& static_tasks();

/// Returns the number of generations, at least 1, until an island reaches the target, or `limit` if no island reaches
/// it. The operators are the operators of section 5.4 of the thesis, except that selection is by rank, because the
/// fitness may be negative. There are `islands` islands of `population` individuals each. Every three generations, each
/// island sends its best individual to the next of its neighbours in the hypercube (section 5.2.1).
std::size_t generations_to_target(const StaticTask& task, std::size_t islands, std::size_t population,
                                  std::size_t limit, std::uint64_t seed);

/// The number of generations or evaluations that a task takes, for several sizes of the search (islands or individuals)
/// and all seeds of an experiment.
struct TaskStudy {
    StaticTask task;
    std::vector<std::size_t> sizes;
    double limit = 0;                       ///< value of `taken` if the target is not reached
    std::vector<std::vector<double>> taken; ///< [size][seed]

    std::size_t reached(std::size_t size) const;
    /// Returns the percentage of the runs that reach the target.
    double reached_percent(std::size_t size) const;
    double median(std::size_t size) const;
};

/// Returns generations_to_target() for every seed of the replay.
std::vector<double> study_task(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                               std::size_t population, std::size_t limit);

/// Returns, for every seed, the best objective that any island has reached so far, generation by generation.
ConvergenceCurve study_convergence(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                                   std::size_t population, std::size_t generations);

/// Returns a table with a row for each task and size: the median of `taken` in the column `column`, and the percentage
/// of runs that reach the target. `name_of_size` names a size in a row.
Comparison tasks_comparison(std::string name, const std::vector<TaskStudy>& studies, const char* column, int decimals,
                            const std::function<std::string(std::size_t)>& name_of_size);
/// Plots the median of `taken` with its 95 % interval against the size. Leaves out sizes at which at most 90 % of the
/// runs reach the target.
Panel taken_panel(std::string title, Axis x, Axis y, const std::vector<TaskStudy>& studies);
/// Plots the percentage of runs that reach the target, with 95 % intervals, against the size.
Panel reached_panel(std::string title, Axis x, const std::vector<TaskStudy>& studies);

} // namespace placedpar
