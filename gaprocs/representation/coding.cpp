#include "gaprocs/representation/coding.hpp"

namespace placedpar {

Genome unstuffed(const Genome& genome, std::size_t dont_care) {
    Genome bits((genome.size() + dont_care) / (1 + dont_care));
    for (std::size_t i = 0; i < bits.size(); ++i)
        bits.set(i, genome.bit(i * (1 + dont_care)));
    return bits;
}

} // namespace placedpar
