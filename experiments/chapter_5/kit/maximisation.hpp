#pragma once

#include "experiments/kit/experiment.hpp"
#include "gaprocs/islands.hpp"

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

/// That of every seed of the replay.
std::vector<double> study_task(const ReplayContext& context, const StaticTask& task, std::size_t islands,
                               std::size_t population, std::size_t limit);

} // namespace placedpar
