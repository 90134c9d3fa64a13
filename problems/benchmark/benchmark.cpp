#include "problems/benchmark/benchmark.hpp"

#include "problems/benchmark/functions.hpp"
#include "problems/benchmark/strings.hpp"
#include "problems/benchmark/tours.hpp"

namespace placedpar {

void add_benchmark_problems(ProblemRegistry& problems) {
    for (const ProblemFamily& family :
         {minimised<Sphere>(), minimised<Rosenbrock>(), minimised<StepFunction>(), minimised<Quartic>(),
          minimised<Foxholes>(), minimised<Rastrigin>(), minimised<Ackley>(), minimised<Schwefel>(),
          minimised<Griewank>(), maximised<OneMax>(), maximised<Trap>(), maximised<NkLandscape>(),
          minimised<CircleTour>(), minimised<LatticeTour>(), minimised<RandomTour>(), minimised<Costly>()})
        problems.add(family);
}

} // namespace placedpar
