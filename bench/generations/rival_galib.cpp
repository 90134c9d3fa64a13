// This rival is GAlib 2.4 (M. Wall, MIT): GASimpleGA on the same strings of 37 bits, with the same rates and an elite
// of one. It uses stochastic remainder selection, which is the most similar to our universal sampling.

#include "bench/generations/contest.hpp"

#include <ga/GA1DBinStrGenome.h>
#include <ga/GASimpleGA.h>

#include <algorithm>

namespace placedpar {

namespace {

/// Reads the fields of a GA1DBinaryStringGenome for PlantProblem, as Genome does.
struct Fields {
    const GA1DBinaryStringGenome& genome;
    std::uint64_t field(std::size_t first, std::size_t count) const {
        std::uint64_t code = 0;
        for (std::size_t bit = first; bit < first + count; ++bit)
            code = 2 * code + static_cast<std::uint64_t>(genome.gene(static_cast<unsigned>(bit)));
        return code;
    }
};

/// The data to which GAGenome::userData() points.
struct Objective {
    PlantProblem problem;
    std::span<const std::vector<double>> window;
};

PoleZeroPlant plant_of(GAGenome& genome) {
    auto& data = *static_cast<Objective*>(genome.userData());
    return data.problem.plant(Fields{static_cast<GA1DBinaryStringGenome&>(genome)});
}

/// Returns the fitness, or 0 if it is negative, because the selection takes no negative numbers.
float objective(GAGenome& genome) {
    auto& data = *static_cast<Objective*>(genome.userData());
    return static_cast<float>(std::max(Chase::fitness(plant_of(genome), data.window), 0.0));
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

Answer follow(const Chase& chase) {
    Objective data{PlantProblem(), chase.window_at(0)};
    GARandomSeed(static_cast<unsigned>(chase.seed));
    GA1DBinaryStringGenome genome(static_cast<unsigned>(data.problem.bits()), objective, &data);
    genome.crossover(GA1DBinaryStringGenome::OnePointCrossover);
    MovingWindowGA ga(genome);
    ga.populationSize(Chase::population);
    ga.pCrossover(static_cast<float>(Chase::crossover));
    ga.pMutation(static_cast<float>(Chase::mutation));
    ga.scaling(GANoScaling());
    ga.selector(GASRSSelector());
    ga.elitist(gaTrue);
    ga.scoreFrequency(0);
    ga.flushFrequency(0);
    ga.initialize(static_cast<unsigned>(chase.seed));
    Answer answer;
    for (std::size_t window = 0; window < chase.windows(); ++window) {
        data.window = chase.window_at(window);
        if (window > 0)
            ga.evaluate_again();
        for (std::size_t trial = 1; trial < Chase::trials; ++trial) // the evaluation above is the first generation
            ga.step();
        PoleZeroPlant best = plant_of(ga.population().best());
        answer.poles.push_back({best.alpha, best.beta});
    }
    return answer;
}

} // namespace

std::vector<Contestant> galib() { return {{"GAlib GASimpleGA, elitist", follow}}; }

} // namespace placedpar
