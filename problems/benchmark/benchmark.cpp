#include "problems/benchmark/benchmark.hpp"

#include "problems/benchmark/constrained.hpp"
#include "problems/benchmark/fronts.hpp"
#include "problems/benchmark/functions.hpp"
#include "problems/benchmark/strings.hpp"
#include "problems/benchmark/tour_file.hpp"
#include "problems/benchmark/tours.hpp"

namespace placedpar {

void add_benchmark_problems(ProblemRegistry& problems) {
    for (const ProblemFamily& family :
         {minimised<Sphere>(),     minimised<Rosenbrock>(),  minimised<StepFunction>(), minimised<Quartic>(),
          minimised<Foxholes>(),   minimised<Rastrigin>(),   minimised<Ackley>(),       minimised<Schwefel>(),
          minimised<Griewank>(),   maximised<OneMax>(),      maximised<Trap>(),         maximised<NkLandscape>(),
          minimised<CircleTour>(), minimised<LatticeTour>(), minimised<RandomTour>(),   minimised<Costly>(),
          minimised<G01>(),        minimised<G02>(),         minimised<G03>(),          minimised<G04>(),
          minimised<G05>(),        minimised<G06>(),         minimised<Zdt1>(),         minimised<Zdt2>(),
          minimised<Zdt3>(),       minimised<Zdt4>()})
        problems.add(family);
    problems.add_reader("tsp", {"a travelling-salesman file of TSPLIB",
                                [](const std::string& file) { return minimise(read_tour_file(file)); }});
}

} // namespace placedpar
