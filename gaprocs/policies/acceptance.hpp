#pragma once

#include "gaprocs/policies/individual.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

class RandomStream;

/// An island whose immigrants look for places.
struct IslandPopulation {
    std::span<const Genome> strings;
    std::span<const double> fitness;
    std::size_t elite = 0; ///< the best, who are never replaced; of equals, those of higher index
    const Representation* representation = nullptr; ///< binary strings where it is null
};

/// Where each immigrant comes to live: the index of the individual that it replaces, or nothing where it is turned
/// away.
using Places = std::vector<std::optional<std::size_t>>;

// Each way gives the immigrants their places, to one after the other. No two get the same place, so that those who come
// together do not replace each other. With `only_if_better`, an immigrant that is not fitter than the one it would
// replace is turned away.
// REQUIRES, everywhere: immigrants.size() + island.elite <= island.fitness.size(), all strings of one length.

/// The least fit; the lower index first among equals. Draws nothing.
struct WorstAcceptance {
    static constexpr std::string_view name = "worst", about = "the least fit is replaced";
    bool only_if_better = false;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"only_if_better", &WorstAcceptance::only_if_better, 0, 1});
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const;
};

/// Anyone who is not of the elite, with the same chance. At least one number an immigrant.
struct RandomAcceptance {
    static constexpr std::string_view name = "random", about = "one drawn at random, not of the elite, is replaced";
    bool only_if_better = false;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"only_if_better", &RandomAcceptance::only_if_better, 0, 1});
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const;
};

/// The one that is least distant from the immigrant (Representation::distance(); of binary strings, it differs in the
/// fewest bits) and is not of the elite; among equals the least fit, then
/// the lowest index. Draws nothing.
struct AlikeAcceptance {
    static constexpr std::string_view name = "alike", about = "the most alike, not of the elite, is replaced";
    bool only_if_better = false;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"only_if_better", &AlikeAcceptance::only_if_better, 0, 1});
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const;
};

/// Who is replaced by an immigrant.
class Acceptance : public OneOf<WorstAcceptance, RandomAcceptance, AlikeAcceptance> {
public:
    using OneOf::OneOf;
    static Acceptance named(std::string_view text) { return read<Acceptance>(text); }

    /// Throws UserError for more immigrants than may be replaced. REQUIRES: every fitness is a finite number,
    /// island.elite <= island.fitness.size(), all strings of one length.
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const;
};

} // namespace placedpar
