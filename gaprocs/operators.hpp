#pragma once

#include "gaprocs/genome.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

// The three operators of the simple genetic algorithm (thesis 1.1), each by itself. None keeps a state: the same stream
// at the same position gives the same offspring.

/// A wheel with a sector as wide as max(f_i, 0) for each individual.
class RouletteWheel {
public:
    /// Throws std::invalid_argument when the sum is beyond a double.
    explicit RouletteWheel(std::span<const double> fitness);

    /// No fitness is positive, or their sum is below the smallest normal double.
    bool empty() const;
    /// The individual whose sector the ball lies in, never one without a sector. Sector i holds its lower
    /// end, not its upper. REQUIRES: not empty, 0 <= turn <= 1 - 2^-32.
    std::size_t sector(double turn) const;
    /// The individuals that `balls` evenly spaced balls lie with, the first at turn / balls, in order.
    /// REQUIRES: as sector().
    std::vector<std::size_t> sectors(std::size_t balls, double turn) const;

private:
    std::vector<double> ends_;
};

/// Reproduction by roulette: individual i is drawn with probability max(f_i, 0) / sum, with replacement, so
/// that individuals of fitness <= 0 (or not a number) are discarded (thesis 3.1.1, step 4).
struct RouletteReproduction {
    /// Indices of `count` parents; nothing, and nothing drawn, when no fitness is positive.
    /// One number of the stream a parent. Throws as RouletteWheel.
    std::optional<std::vector<std::size_t>> operator()(std::span<const double> fitness, std::size_t count,
                                                       RandomStream& random) const;
};

/// Stochastic universal sampling (J. Baker, "Reducing bias and inefficiency in the selection algorithm", 1987): one
/// spin of a wheel with `count` evenly spaced balls, so that individual i becomes a parent floor(e) or ceil(e) times,
/// e = count max(f_i, 0) / sum being what roulette gives on average. The parents are then shuffled, since crossover
/// takes neighbours for mates.
struct UniversalReproduction {
    /// As RouletteReproduction, but for the numbers drawn: one for the spin, at least count - 1 for the shuffle.
    std::optional<std::vector<std::size_t>> operator()(std::span<const double> fitness, std::size_t count,
                                                       RandomStream& random) const;
};

/// One-point crossover: neighbours 0 and 1, 2 and 3, ... are mates; with the given probability they exchange
/// the characters 1 ... k, k uniform in 1 ... L - 1 (thesis eq. 1.1 and 1.2). After roulette neighbours are
/// mates at random already. The last of an odd number has no mate, and strings of length 1 have no cut.
struct OnePointCrossover {
    double probability = 0.8;
    /// REQUIRES: all strings of one length.
    void operator()(std::span<Genome> population, RandomStream& random) const;
};

/// Mutation: every bit is flipped with the given probability. One number of the stream a bit.
struct BitMutation {
    double probability = 0.01;
    void operator()(std::span<Genome> population, RandomStream& random) const;
};

/// `count` random strings of `bits` bits.
std::vector<Genome> random_population(std::size_t count, std::size_t bits, RandomStream& random);

} // namespace placedpar
