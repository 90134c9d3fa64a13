#pragma once

#include "gaprocs/policies/policy.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

class RandomStream;

// Each policy below is one way to choose `count` different individuals of an island, of which copies go to other
// islands. It returns their indices. REQUIRES of every policy: count <= fitness.size().

/// Chooses the best individuals; among equals the lowest index first. Draws no random number.
struct BestEmigration {
    static constexpr std::string_view name = "best", about = "the `count` best individuals",
                                      source = "thesis 4.3 and 5.2.1";
    std::size_t count = 1;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"count", &BestEmigration::count, 1, 1e6, "individuals that leave"});
    }
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream& random) const;
};

/// Chooses individuals at random, all with the same probability. Draws at least one random number for each emigrant.
struct RandomEmigration {
    static constexpr std::string_view name = "random", about = "`count` individuals drawn at random",
                                      source = "a control for comparisons, not in the thesis";
    std::size_t count = 1;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"count", &RandomEmigration::count, 1, 1e6, "individuals that leave"});
    }
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream& random) const;
};

/// Chooses each emigrant by a tournament: the best of `size` individuals, drawn with replacement from the individuals
/// not yet chosen; among equals the individual drawn first. Draws at least `size` random numbers for each emigrant.
struct TournamentEmigration {
    static constexpr std::string_view name = "tournament",
                                      about = "`count` individuals, each the best of `size` drawn at random",
                                      source = "not in the thesis";
    std::size_t count = 1, size = 2;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"count", &TournamentEmigration::count, 1, 1e6, "individuals that leave"},
            PolicyNumber{"size", &TournamentEmigration::size, 1, 1e6, "individuals drawn for each emigrant"});
    }
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream& random) const;
};

/// A user-defined struct with a number `count` and the same call operator as the policies above. The returned indices
/// are checked.
class OwnEmigration : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnEmigration(Policy policy) : OwnPolicy(policy), count(policy.count), choose_(std::move(policy)) {}
    std::size_t count;
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream& random) const;

private:
    std::function<std::vector<std::size_t>(std::span<const double>, RandomStream&)> choose_;
};

/// The policy that selects the individuals that leave an island.
class Emigration : public OneOf<Emigration, BestEmigration, RandomEmigration, TournamentEmigration, OwnEmigration> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "emigration",
                                      about = "which individuals leave an island as copies, and how many";

    /// Returns the number of individuals that leave in one exchange.
    std::size_t count() const;
    /// Throws UserError if count() exceeds the population.
    void validate_for(std::size_t population) const;
    /// Returns the indices of the individuals that leave. Throws what validate_for() throws. REQUIRES: every fitness is
    /// a finite number.
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream& random) const;
};

} // namespace placedpar
