#pragma once

#include "gaprocs/islands.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "problems/plant/plant_record.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// A configuration of Table 5.3: islands that search for the parameters of a plant that changes.
struct PlantIslands {
    std::string name;
    std::vector<std::size_t> populations{100}, windows{30}; ///< one for each island; windows in samples
    std::string topology = "none", schedule = "broadcast(every = 12)";
    std::string reproduction = "universal"; ///< selection for the fitness max(0, sum(B - e^2))
    Coding coding = Coding::natural;
    double bias = 10;       ///< B for one sample
    bool simulated = false; ///< whether the outputs y-hat inside the window are simulated from the two outputs measured
                            ///< before the window
    PlantExperiment plant = {};
    /// Names of rules (IslandChoice), which are compared. At each broadcast, each rule chooses an island. The best
    /// individual of this island is then the answer of all islands by this rule.
    std::vector<std::string> choices = {};
};

/// The windows and populations of Table 5.3, island by island: first the values that differ between islands, then the
/// values that are equal on all islands.
inline const std::vector<std::size_t> distributed_windows{30, 24, 16, 10}, distributed_populations{24, 30, 40, 50},
    equal_windows{30, 30, 30, 30}, equal_populations{24, 24, 24, 24};

/// The results, generation by generation.
struct PlantSearchRun {
    std::vector<std::vector<Pole>> islands; ///< each island's best individual
    std::vector<std::vector<Pole>> answers; ///< for each rule, the best individual of the chosen island; before the
                                            ///< first broadcast, the best individual of island 0
    std::vector<std::vector<std::size_t>> chosen; ///< for each rule, the island chosen at each broadcast
    double diversity = 0; ///< mean number of bits in which two individuals of an island differ, over all islands and
                          ///< every tenth generation from 400 to 600
    /// Share of these generations in which the best individuals of the first and the last island are equal.
    double identical = 0;
};

/// Returns the plant's measurements for this seed. All methods with the same seed get the same measurements.
std::vector<std::vector<double>> plant_samples(const PlantExperiment& plant, std::uint64_t seed);

/// Searches with the operators of section 5.4 and one elite individual. The seed determines the record and all
/// searches.
PlantSearchRun search_plant(const PlantIslands& islands, std::uint64_t seed);

} // namespace placedpar
