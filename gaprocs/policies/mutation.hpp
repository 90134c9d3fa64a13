#pragma once

#include "gaprocs/representation/genome.hpp"

#include <span>

namespace placedpar {

/// Mutation: every bit is flipped with the given probability. One number of the stream a bit.
struct BitMutation {
    double probability = 0.01;
    void operator()(std::span<Genome> population, RandomStream& random) const;
};

} // namespace placedpar
