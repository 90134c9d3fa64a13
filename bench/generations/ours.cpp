#include "bench/generations/contest.hpp"
#include "gaprocs/traditional.hpp"
#include "runtime/vector_width.hpp"

namespace placedpar {

namespace {

template <class WayToMutate>
Answer follow(const Chase& chase, Coding coding, std::size_t width, std::size_t population = Chase::population) {
    SearchSettings settings;
    settings.population = population;
    settings.crossover_probability = Chase::crossover;
    settings.mutation_probability = Chase::mutation;
    settings.elite = 1;
    settings.reproduction = UniversalReproduction{};
    settings.mutation = WayToMutate{};
    settings.window = {Chase::window, Chase::window, Chase::trials, Chase::bias};
    use_vector_width(width);
    auto problem = make_search_problem(PlantProblem(), coding);
    SearchResult result = run_traditional(*problem, chase.record, settings, RandomStream(chase.seed, "search"));
    use_vector_width(widest_vector_width());
    Answer answer;
    for (const Estimate& estimate : result.estimates)
        answer.poles.push_back({estimate.parameters[1], estimate.parameters[2]});
    return answer;
}

template <std::size_t width>
Answer distances(const Chase& chase) {
    return follow<DistanceMutation>(chase, Coding::natural, width);
}
Answer bits(const Chase& chase) { return follow<BitMutation>(chase, Coding::natural, widest_vector_width()); }
Answer gray(const Chase& chase) { return follow<DistanceMutation>(chase, Coding::gray, widest_vector_width()); }
/// As near to the pole as the nearest rival.
Answer large(const Chase& chase) {
    return follow<DistanceMutation>(chase, Coding::gray, widest_vector_width(), 3 * Chase::population);
}

} // namespace

std::vector<Contestant> ours() {
    std::vector<Contestant> all{{"PlacedPar, 2 doubles at once", distances<2>}};
    if (widest_vector_width() >= 4)
        all.push_back({"PlacedPar, 4 doubles at once", distances<4>});
    if (widest_vector_width() >= 8)
        all.push_back({"PlacedPar, 8 doubles at once", distances<8>});
    all.push_back({"... Gray code", gray});
    all.push_back({"... Gray code, 300 individuals", large});
    all.push_back({"... a number for every bit", bits});
    return all;
}

} // namespace placedpar
