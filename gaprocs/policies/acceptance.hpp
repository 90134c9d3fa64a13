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

/// The population into which immigrants come.
struct IslandPopulation {
    std::span<const Genome> strings;
    std::span<const double> fitness;
    std::size_t elite = 0; ///< number of best individuals that are never replaced; among equals, the individuals of
                           ///< higher index. In a population that has just been bred, they are the first
    const Representation* representation = nullptr; ///< null: binary strings
};

/// For each immigrant, the index of the individual that it replaces, or nothing if the immigrant is rejected.
using Places = std::vector<std::optional<std::size_t>>;

// Each policy assigns places to the immigrants in turn. Immigrants of the same exchange get different places, so that
// none replaces another. With `only_if_better`, an immigrant is rejected unless it is fitter than the individual that
// it would replace. REQUIRES of every policy: immigrants.size() + island.elite <= island.strings.size(), and all
// strings have the same length.

/// Replaces the least fit individuals; among equals the lowest index first. Draws no number.
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

/// Replaces an individual outside the elite, each with the same probability. Draws at least one number for each
/// immigrant.
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

/// Replaces the individual outside the elite that is most similar to the immigrant: with the least
/// Representation::distance(), which for binary strings is the number of different bits. Among equals it replaces the
/// least fit, then the lowest index. Draws no number.
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

/// Replaces an individual of the population that has just been bred, each with the same probability; the elite at the
/// beginning of the population is never replaced. So an immigrant is evaluated with the next generation and cannot
/// become a parent earlier (thesis 5.3.2: "one generation later"). The population has no fitness yet, so no immigrant
/// is rejected. Draws at least one number for each immigrant.
struct OffspringAcceptance {
    static constexpr std::string_view name = "offspring",
                                      about = "an individual of the new population outside its elite, drawn at random, "
                                              "is replaced; the immigrant is evaluated one generation later",
                                      source = "thesis 5.3.2, \"one generation later\"";
    static constexpr std::tuple<> numbers() { return {}; }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;
};

/// A user-defined struct with a call operator like those above. The places that it returns are checked.
class OwnAcceptance : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnAcceptance(Policy policy) : OwnPolicy(policy), choose_(std::move(policy)) {}
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;

private:
    std::function<Places(const IslandPopulation&, std::span<const Individual>, RandomStream&)> choose_;
};

/// The policy that selects the individual that each immigrant replaces.
class Acceptance
    : public OneOf<Acceptance, WorstAcceptance, RandomAcceptance, AlikeAcceptance, OffspringAcceptance, OwnAcceptance> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "acceptance", about = "which individual an immigrant replaces";

    /// Returns whether immigrants come into the population that has just been bred; otherwise they come into the
    /// population of its parents.
    bool among_offspring() const { return std::holds_alternative<OffspringAcceptance>(policy()); }

    /// Throws UserError if the number of immigrants in one exchange exceeds the number of individuals outside the
    /// elite. REQUIRES: elite <= population.
    static void validate_for(std::size_t immigrants, std::size_t population, std::size_t elite);
    /// Throws as validate_for(). REQUIRES: all strings have the same length, and island.elite is at most their number.
    /// Every string has a fitness, which is a finite number, unless among_offspring().
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;
};

} // namespace placedpar
