#pragma once

#include "gaprocs/representation/genome.hpp"
#include "picture/hypercube.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// A search that is small enough to be done by hand: strings of four bits, the vertices of Figure 6.2, roulette,
/// one-point crossover, mutation.
struct WalkSettings {
    std::size_t population = 6;
    double crossover_probability = 0.8;
    double mutation_probability = 0.05; ///< ours: at the thesis's .01 hardly any bit of so few is flipped
    std::string function = "square";    ///< one of walk_functions()
    std::uint64_t seed = 1;
};

inline constexpr std::size_t walk_bits = 4;

/// "square": x^2; "ones": how many bits are 1; "impulse": 1 at 1011 and 0 elsewhere (Figure 6.5).
std::vector<std::string> walk_functions();

/// What a pair of mates drew.
struct Mating {
    double drawn; ///< below the crossover probability: they are crossed
    bool crossed;
    std::size_t cut; ///< characters before it are exchanged; where they are crossed
};

/// One generation, step by step (thesis 1.1, Figure 6.4). Strings at one place of the lists belong together.
struct WalkedGeneration {
    std::size_t number; ///< from 1
    std::vector<Genome> population = {};
    std::vector<double> fitness = {};
    std::vector<double> spins = {};        ///< of the roulette, 0 to 1; empty where no fitness is positive
    std::vector<std::size_t> parents = {}; ///< by index in the population; empty likewise
    std::vector<Genome> reproduced = {};
    std::vector<Mating> matings = {}; ///< of strings 0 and 1, 2 and 3, ...
    std::vector<Genome> crossed = {}, mutated = {};
};

/// The generations of Search with the same settings and stream, bit for bit, and what was drawn for them.
class GenerationWalk {
public:
    /// Throws UserError: as SearchSettings::validate(), and for a function that there is not.
    explicit GenerationWalk(const WalkSettings& settings);

    WalkedGeneration next();

private:
    void reproduce(WalkedGeneration& walked);
    void cross(WalkedGeneration& walked);

    WalkSettings settings_;
    RandomStream random_;
    std::vector<Genome> population_;
    std::size_t generations_ = 0;
};

/// For students: every step as a table, with the numbers that were drawn, and the schemata of order 1 with what
/// equation 6.2 says of them.
std::string print_walk(const WalkedGeneration&, const WalkSettings&);

/// Steps 0 to 3 of Figure 6.4: the population, after reproduction, mates and offspring, the next population.
std::vector<DrawnHypercube> draw_walk(const WalkedGeneration&);
VertexLegend walk_legend();

} // namespace placedpar
