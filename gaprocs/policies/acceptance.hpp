#pragma once

#include "gaprocs/policies/individual.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace placedpar {

class RandomStream;

/// The population of an island that receives immigrants.
struct IslandPopulation {
    std::span<const Genome> strings;
    std::span<const double> fitness;
    std::size_t elite = 0; ///< number of best individuals, which are never replaced. Among equally fit individuals, the
                           ///< individuals with the higher index belong to the elite. In a population that has just
                           ///< been bred, the elite comes first
    const Representation* representation = nullptr; ///< null: binary strings
};

/// For each immigrant, the index of the individual that it replaces, or nothing if the immigrant is rejected.
using Places = std::vector<std::optional<std::size_t>>;

// Each policy below is one way to choose the individual that an immigrant replaces, for one immigrant after another.
// Immigrants of the same exchange replace different individuals. With `only_if_better`, an immigrant is rejected unless
// it is fitter than the individual that it would replace. REQUIRES of every policy: immigrants.size() + island.elite <=
// island.strings.size(), and all strings have the same length.

/// Replaces the least fit individuals; among equals the lowest index first. Draws no random number.
struct WorstAcceptance {
    static constexpr std::string_view name = "worst", about = "the least fit individual is replaced",
                                      source = "PlacedPar's choice: the thesis states none";
    bool only_if_better = false;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"only_if_better", &WorstAcceptance::only_if_better, 0, 1,
                                       "1: replaces the individual only if the immigrant is fitter; 0: always"});
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const;
};

/// Replaces a random individual outside the elite. Draws at least one random number for each immigrant.
struct RandomAcceptance {
    static constexpr std::string_view name = "random",
                                      about = "an individual outside the elite, drawn at random, is replaced",
                                      source = "not in the thesis";
    bool only_if_better = false;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"only_if_better", &RandomAcceptance::only_if_better, 0, 1,
                                       "1: replaces the individual only if the immigrant is fitter; 0: always"});
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const;
};

/// Replaces the individual most similar to the immigrant: the individual outside the elite with the least
/// Representation::distance() from the immigrant. For binary strings this distance is the number of different bits.
/// Among equally distant individuals the policy replaces the least fit, and among equally fit individuals the
/// individual with the lowest index. Draws no random number.
struct AlikeAcceptance {
    static constexpr std::string_view name = "alike",
                                      about = "the most similar individual outside the elite is replaced",
                                      source = "not in the thesis";
    bool only_if_better = false;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"only_if_better", &AlikeAcceptance::only_if_better, 0, 1,
                                       "1: replaces the individual only if the immigrant is fitter; 0: always"});
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const;
};

/// Replaces a random individual of the population that has just been bred, except the elite at its beginning. So an
/// immigrant is evaluated, and may become a parent, one generation later than with the other policies (thesis 5.3.2:
/// "one generation later"). The new population has no fitness yet, so no immigrant is rejected. Draws at least one
/// random number for each immigrant.
struct OffspringAcceptance {
    static constexpr std::string_view name = "offspring",
                                      about = "an individual of the new population outside its elite, drawn at random, "
                                              "is replaced; the immigrant is evaluated one generation later",
                                      source = "thesis 5.3.2, \"one generation later\"";
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;
};

/// A user-defined struct with the same call operator as the policies above. The returned places are checked.
class OwnAcceptance : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnAcceptance(Policy policy) : OwnPolicy(policy), choose_(std::move(policy)) {}
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;

private:
    std::function<Places(const IslandPopulation&, std::span<const Individual>, RandomStream&)> choose_;
};

/// The policy that chooses, for each immigrant, the individual that it replaces.
class Acceptance
    : public OneOf<Acceptance, WorstAcceptance, RandomAcceptance, AlikeAcceptance, OffspringAcceptance, OwnAcceptance> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "acceptance", about = "which individual an immigrant replaces";

    /// Returns whether immigrants replace individuals that have just been bred. Otherwise they replace individuals that
    /// have just been evaluated.
    bool among_offspring() const { return std::holds_alternative<OffspringAcceptance>(policy()); }

    /// Throws UserError if the number of immigrants in one exchange exceeds the number of individuals outside the
    /// elite. REQUIRES: elite <= population.
    static void validate_for(std::size_t immigrants, std::size_t population, std::size_t elite);
    /// Returns, for each immigrant, the individual that it replaces. Throws what validate_for() throws. REQUIRES: all
    /// strings have the same length, island.elite <= island.strings.size(), and, unless among_offspring(), every string
    /// has a finite fitness.
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;
};

} // namespace placedpar
