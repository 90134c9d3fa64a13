// This program evolves an archipelago of pagmo on Rastrigin's function in 20 dimensions: two islands in a ring, each on
// a thread of its own. Each island has 100 individuals and uses the genetic algorithm `sga`. The islands exchange
// individuals after every third generation. The program prints the seconds of the wall clock, the evaluations and the
// best value. It uses nothing of PlacedPar.
//
// usage: rastrigin_archipelago GENERATIONS

#include <pagmo/algorithms/sga.hpp>
#include <pagmo/archipelago.hpp>
#include <pagmo/problems/rastrigin.hpp>
#include <pagmo/topologies/ring.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

int main(int arguments, char** argument) {
    constexpr unsigned islands = 2, individuals = 100, dimensions = 20, exchange_every = 3;
    const long generations = arguments == 2 ? std::strtol(argument[1], nullptr, 10) : 0;
    if (generations < 1) {
        std::fprintf(stderr, "usage: rastrigin_archipelago GENERATIONS, at least 1\n");
        return 1;
    }
    const auto begun = std::chrono::steady_clock::now();
    pagmo::archipelago archipelago(pagmo::ring(), islands, pagmo::sga(exchange_every), pagmo::rastrigin(dimensions),
                                   individuals, 1U);
    archipelago.evolve(static_cast<unsigned>(generations - 1) / exchange_every); // a population is evaluated first
    archipelago.wait_check();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    unsigned long long evaluations = 0;
    double best = archipelago.get_champions_f()[0][0];
    for (const auto& island : archipelago)
        evaluations += island.get_population().get_problem().get_fevals();
    for (const auto& champion : archipelago.get_champions_f())
        best = std::min(best, champion[0]);
    std::printf("%.3f s, %llu evaluations, best %g\n", took.count(), evaluations, best);
}
