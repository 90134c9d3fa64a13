// This rival is GAlib 2.4 (M. Wall, MIT): GASimpleGA on strings of 10 bits, with the thesis's operators and rates.

#include "bench/identification/contest.hpp"

#include <ga/GA1DBinStrGenome.h>
#include <ga/GASimpleGA.h>

#include <algorithm>

namespace placedpar {

using namespace hydraulics;

namespace {

/// The data to which GAGenome::userData() points.
struct Objective {
    const Transient& transient;
    std::span<const LinkSample> window;
    std::uint64_t error_evaluations = 0;
};

double compliance(const GA1DBinaryStringGenome& genome) {
    unsigned code = 0;
    for (unsigned bit = 0; bit < Transient::bits; ++bit)
        code = 2 * code + static_cast<unsigned>(genome.gene(bit));
    return Transient::largest * code / (1u << Transient::bits);
}

/// Returns the fitness, or 0 if it is negative, because the roulette takes no negative numbers.
float objective(GAGenome& genome) {
    auto& data = *static_cast<Objective*>(genome.userData());
    data.error_evaluations += data.window.size();
    double fitness = data.transient.fitness(compliance(static_cast<GA1DBinaryStringGenome&>(genome)), data.window);
    return static_cast<float>(std::max(fitness, 0.0));
}

/// Evaluates all individuals again when the window moves, because GAlib caches their fitness.
class MovingWindowGA : public GASimpleGA {
public:
    using GASimpleGA::GASimpleGA;
    void evaluate_again() {
        for (int i = 0; i < pop->size(); ++i)
            pop->individual(static_cast<unsigned>(i)).evaluate(gaTrue);
        pop->touch();
        pop->evaluate();
    }
};

template <bool elitist>
Answer identify(const Transient& transient) {
    Objective data{transient, transient.window_at(0)};
    GARandomSeed(static_cast<unsigned>(transient.seed));
    GA1DBinaryStringGenome genome(Transient::bits, objective, &data);
    genome.crossover(GA1DBinaryStringGenome::OnePointCrossover);
    MovingWindowGA ga(genome);
    ga.populationSize(Transient::population);
    ga.pCrossover(static_cast<float>(Transient::crossover));
    ga.pMutation(static_cast<float>(Transient::mutation));
    ga.scaling(GANoScaling());
    ga.selector(GARouletteWheelSelector());
    ga.elitist(elitist ? gaTrue : gaFalse);
    ga.scoreFrequency(0);
    ga.flushFrequency(0);
    ga.initialize(static_cast<unsigned>(transient.seed));
    for (std::size_t window = 0; window < transient.windows(); ++window) {
        data.window = transient.window_at(window);
        if (window > 0)
            ga.evaluate_again();
        for (std::size_t trial = 1; trial < Transient::trials; ++trial) // the evaluation above is the first generation
            ga.step();
    }
    auto& best = static_cast<GA1DBinaryStringGenome&>(ga.population().best());
    return {compliance(best), data.error_evaluations};
}

} // namespace

std::vector<Contestant> galib() {
    return {{"GAlib GASimpleGA", identify<false>}, {"GAlib GASimpleGA, elitist", identify<true>}};
}

} // namespace placedpar
