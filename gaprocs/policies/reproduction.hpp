#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/policies/roulette_wheel.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace placedpar {

class RandomStream;

/// The indices of the parents; nothing if no individual may become a parent. In this case no random number is drawn.
using Parents = std::optional<std::vector<std::size_t>>;

/// Draws parents with replacement. The probability of individual i is proportional to max(f_i, 0), where f_i is its
/// fitness. So individuals whose fitness is 0, negative or NaN are discarded (thesis 3.1.1, step 4).
struct RouletteReproduction {
    static constexpr std::string_view
        name = "roulette",
        about = "the roulette wheel is spun once for each parent; individuals with fitness <= 0 are discarded",
        source = "thesis 1.1 and 3.1.1, step 4";
    static constexpr bool needs_positive_fitness = true;

    /// Draws one random number for each parent. Throws what the constructor of RouletteWheel throws.
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;
};

/// Stochastic universal sampling (J. Baker, "Reducing bias and inefficiency in the selection algorithm", 1987): one
/// spin of a roulette wheel with `count` evenly spaced balls chooses all parents. If RouletteReproduction chooses an
/// individual e times on average, this policy chooses it floor(e) or ceil(e) times. The parents are then shuffled,
/// because crossover takes neighbours as mates.
struct UniversalReproduction {
    static constexpr std::string_view
        name = "universal",
        about = "stochastic universal sampling: one spin with evenly spaced pointers chooses all parents",
        source = "J. Baker, 1987";
    static constexpr bool needs_positive_fitness = true;

    /// Draws one random number for the spin, and at least count - 1 for the shuffle. Throws what the constructor of
    /// RouletteWheel throws.
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;
};

/// Linear scaling (D. Goldberg, "Genetic Algorithms in Search, Optimization and Machine Learning", 1989, p. 76). The
/// average number of copies is a linear function of fitness: 1 at the mean fitness and `best` for the best individual.
/// If this function would be negative for the worst individual, a flatter function is used, which is 1 at the mean
/// fitness and 0 for the worst individual. Only differences of fitness matter, so fitness may be negative. The parents
/// are sampled as by UniversalReproduction.
struct ScaledReproduction {
    static constexpr std::string_view name = "scaled",
                                      about = "linear scaling: the best individual gets `best` copies on average",
                                      source = "D. Goldberg, 1989, p. 76";
    static constexpr bool needs_positive_fitness = false;
    double best = 2;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"best", &ScaledReproduction::best, 1, 100,
                         "mean number of copies of the best individual; an individual of mean fitness has 1"});
    }

    /// Draws as many numbers as UniversalReproduction. Always returns parents.
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;
};

/// Linear ranking (J. Baker, "Adaptive selection methods for genetic algorithms", 1985). The average number of copies
/// is a linear function of the rank: `best` for the best individual, and 2 - `best` for the worst. Individuals of equal
/// fitness all have the mean of their ranks. The parents are sampled as by UniversalReproduction.
struct RankingReproduction {
    static constexpr std::string_view name = "ranking",
                                      about = "linear ranking: the best individual gets `best` copies on average",
                                      source = "J. Baker, 1985";
    static constexpr bool needs_positive_fitness = false;
    double best = 2;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"best", &RankingReproduction::best, 1, 2,
                         "mean number of copies of the best individual; the worst has 2 minus this number"});
    }

    /// Draws as many numbers as UniversalReproduction. Always returns parents.
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;
};

/// Chooses each parent by a tournament: the best of `size` individuals, drawn with replacement; among equals the
/// individual drawn first.
struct TournamentReproduction {
    static constexpr std::string_view
        name = "tournament",
        about = "each parent is the best of `size` individuals, drawn at random with replacement",
        source = "D. Goldberg and K. Deb, 1991";
    static constexpr bool needs_positive_fitness = false;
    std::size_t size = 2;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"size", &TournamentReproduction::size, 1, 1e6, "individuals drawn for each parent"});
    }

    /// Draws at least `size` random numbers for each parent. Always returns parents.
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;
};

/// A user-defined struct with `needs_positive_fitness` and the same call operator as the policies above. The parents
/// that it returns are checked.
class OwnReproduction : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnReproduction(Policy policy)
        : OwnPolicy(policy), needs_positive_fitness(Policy::needs_positive_fitness), choose_(std::move(policy)) {}
    bool needs_positive_fitness;
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;

private:
    std::function<Parents(std::span<const double>, std::size_t, RandomStream&)> choose_;
};

/// The policy that chooses parents by their fitness (thesis 1.1).
class Reproduction : public OneOf<Reproduction, RouletteReproduction, UniversalReproduction, ScaledReproduction,
                                  RankingReproduction, TournamentReproduction, OwnReproduction> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "selection", about = "how parents are chosen";

    /// Returns whether individuals of fitness <= 0 never become parents.
    bool needs_positive_fitness() const {
        return std::visit([](const auto& way) { return way.needs_positive_fitness; }, policy());
    }

    /// Returns `count` parents. REQUIRES: the population is not empty, and every fitness is a finite number.
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const;
};

} // namespace placedpar
