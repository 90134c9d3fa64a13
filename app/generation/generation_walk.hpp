#pragma once

#include "gaprocs/representation/genome.hpp"
#include "picture/hypercube.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// The settings of a genetic search that is small enough to follow by hand. It has strings of four bits (the vertices
/// of the hypercube in Figure 6.2), roulette, one-point crossover and mutation.
struct WalkSettings {
    std::size_t population = 6;
    double crossover_probability = 0.8;
    double mutation_probability =
        0.05; ///< our choice: with the thesis's value, 0.01, hardly any of the few bits would be flipped
    std::string function = "square"; ///< fitness function, one of walk_functions()
    std::uint64_t seed = 1;
};

inline constexpr std::size_t walk_bits = 4;

/// Returns the names of the fitness functions: "square" is x^2, "ones" is the number of bits that are 1, and "impulse"
/// is 1 for the string 1011 and 0 for all others (Figure 6.5).
std::vector<std::string> walk_functions();

/// What crossover did to a pair of mates, with the random numbers drawn for it.
struct Mating {
    double drawn; ///< random number; if it is below the crossover probability, the pair is crossed
    bool crossed;
    std::size_t cut; ///< number of leading characters that are exchanged, if the pair is crossed
};

/// One generation, step by step (thesis 1.1, Figure 6.4). Strings with the same index in the lists belong together.
struct WalkedGeneration {
    std::size_t number; ///< counted from 1
    std::vector<Genome> population = {};
    std::vector<double> fitness = {};
    std::vector<double> spins = {};        ///< random positions on the roulette wheel, 0 to 1; empty if no fitness is
                                           ///< positive
    std::vector<std::size_t> parents = {}; ///< indices in the population; empty if no fitness is positive
    std::vector<Genome> reproduced = {};
    std::vector<Mating> matings = {}; ///< mating of strings 0 and 1, of strings 2 and 3, ...
    std::vector<Genome> crossed = {}, mutated = {};
};

/// Makes the generations of such a search, and records every random number, so that a student can follow each step. The
/// generations are exactly those that Search, the class of real searches, makes with the same settings and random
/// stream.
class GenerationWalk {
public:
    /// Throws UserError as SearchSettings::validate() does, and for an unknown function.
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

/// Returns a table of every step with its random numbers, and a table of the schemata of order 1 with the predictions
/// of equation 6.2.
std::string print_walk(const WalkedGeneration&, const WalkSettings&);

/// Returns steps 0 to 3 of Figure 6.4: the population, the strings after reproduction, the mates with their offspring,
/// and the next population.
std::vector<DrawnHypercube> draw_walk(const WalkedGeneration&);
VertexLegend walk_legend();

} // namespace placedpar
