#pragma once

#include "gaprocs/genome.hpp"

#include <initializer_list>
#include <vector>

namespace placedpar::test {

/// A population written out.
inline std::vector<Genome> strings(std::initializer_list<const char*> texts) {
    std::vector<Genome> population;
    for (const char* text : texts)
        population.push_back(Genome::from_string(text));
    return population;
}

} // namespace placedpar::test
