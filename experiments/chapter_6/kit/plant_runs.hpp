#pragma once

#include "gaprocs/coarse_fine.hpp"
#include "gaprocs/recoding.hpp"
#include "gaprocs/settings.hpp"
#include "problems/plant/plant_record.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace placedpar {

/// These functions return the plant of chapter 5 as a search problem in natural binary, and the number of bits of each
/// field (Table 5.1).
const SearchProblem& plant_search_problem();
std::vector<std::size_t> plant_field_bits();
/// Returns the coding of a coarse search (Table 6.3). Its strings have the two bits for the delay, and the `bits` most
/// significant bits of each of the five other parameters. With `bits` = 7 these are all bits of the problem.
Recoding plant_reading(std::size_t bits, Coding coding = Coding::natural);

/// Returns the settings that all searches of chapters 5 and 6 have: a window of 30 samples, B = 10 for a sample,
/// stochastic universal sampling, and one elite individual. The probabilities are .8 for crossover and .01 for
/// mutation.
SearchSettings plant_settings(std::size_t population);

/// States how well a search followed the plant's dominant pole while the coefficient a1 changed (Table 5.4), without
/// noise.
struct PlantOutcome {
    static constexpr double near_the_pole = 0.1;

    /// The rms values of |pole found - true pole| over generations 100 to 199, 200 to 399 and 500 to 599.
    std::array<double, 3> pole_error{};
    /// The first generation before the change from which |pole found - true pole| stays below `near_the_pole` for ten
    /// generations; 200 if there is none.
    double converged_at = 0;

    bool converged() const { return pole_error[0] < near_the_pole; }
    bool followed() const { return pole_error[2] < near_the_pole; }
};

/// Collects the distances between the found pole and the true pole, one for each generation.
class PoleTrack {
public:
    void add(const std::vector<double>& parameters);
    PlantOutcome outcome() const;

private:
    std::vector<double> distance_;
};

/// The complete settings of a search of the plant under one condition.
struct PlantSearch {
    SearchSettings settings;
    Recoding reading;
    bool spread_start = false; ///< whether spread_population() makes the first population, which is otherwise random
};

PlantOutcome run_plant_search(const PlantSearch& search, std::uint64_t seed);

/// The results of the coarse and the fine search of a pair.
struct PairOutcome {
    PlantOutcome coarse, fine;
};
PairOutcome run_plant_pair(const CoarseFineSettings& settings, std::uint64_t seed);

} // namespace placedpar
