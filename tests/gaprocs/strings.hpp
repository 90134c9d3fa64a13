#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace placedpar::test {

/// Returns a population of the given strings.
inline std::vector<Genome> strings(std::initializer_list<const char*> texts) {
    std::vector<Genome> population;
    for (const char* text : texts)
        population.push_back(Genome::from_string(text));
    return population;
}

/// Returns, for each position, the number of individuals with a 1 there.
inline std::vector<int> ones_by_position(const std::vector<Genome>& population) {
    std::vector<int> ones(population.front().size());
    for (const Genome& genome : population)
        for (std::size_t bit = 0; bit < genome.size(); ++bit)
            ones[bit] += genome.bit(bit);
    return ones;
}

} // namespace placedpar::test
