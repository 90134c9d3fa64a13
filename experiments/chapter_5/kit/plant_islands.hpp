#pragma once

#include "gaprocs/islands.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "problems/plant/plant_record.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// A configuration of Table 5.3 at work on the changing plant.
struct PlantIslands {
    std::string name;
    std::vector<std::size_t> populations{100}, windows{30}; ///< of each island, windows in samples
    std::string topology = "none", schedule = "broadcast(every = 12)";
    std::string reproduction = "universal"; ///< on max(0, sum of B - e^2)
    Coding coding = Coding::natural;
    double bias = 10;       ///< B, of one sample
    bool simulated = false; ///< y-hat inside the window, from the two outputs measured before it
    PlantExperiment plant = {};
    /// Whose bests are answers of all, by the names of IslandChoice: analysed at each broadcast.
    std::vector<std::string> choices = {};
};

/// 30:24:16:10 and 24:30:40:50; 30:30:30:30 and 24:24:24:24.
inline const std::vector<std::size_t> distributed_windows{30, 24, 16, 10}, distributed_populations{24, 30, 40, 50},
    equal_windows{30, 30, 30, 30}, equal_populations{24, 24, 24, 24};

/// What was found, generation by generation.
struct PlantSearchRun {
    std::vector<std::vector<Pole>> islands;       ///< of each island's best
    std::vector<std::vector<Pole>> answers;       ///< of each choice's island; before the first broadcast island 0's
    std::vector<std::vector<std::size_t>> chosen; ///< by each choice, at each broadcast
    double diversity = 0; ///< bits in which two of an island differ on average, over islands and generations 400 to 600
    double identical = 0; ///< share of the generations 400 to 600 in which the bests of first and last island are one
};

/// What is measured of the plant: the same for everything that is tried with a seed.
std::vector<std::vector<double>> plant_samples(const PlantExperiment& plant, std::uint64_t seed);

/// Operators as in 5.4, one elite; the record and all searches by the seed.
PlantSearchRun search_plant(const PlantIslands& islands, std::uint64_t seed);

} // namespace placedpar
