#pragma once

#include "gaprocs/policies/own_variation.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <tuple>

namespace placedpar {

/// Calls `mutate` for each position of each string, with the given probability. Draws one random number for each
/// position, besides the draws of `mutate`.
template <class Mutate>
void mutate_places(const Mutate& mutate, std::span<Genome> population, double probability,
                   const Representation& representation, RandomStream& random) {
    const std::size_t places = representation.bits() / representation.unit();
    for (Genome& genome : population)
        for (std::size_t place = 0; place < places; ++place)
            if (random.chance(probability))
                mutate(genome, place, representation, random);
}

// BitMutation and DistanceMutation flip bits of a whole population. Each other policy changes one position of a string;
// the class Mutation chooses the positions. The comment of each policy states how many random numbers the policy draws.

/// Flips each bit with probability `probability`. Draws one random number for each bit. REQUIRES: all strings have the
/// same length.
struct BitMutation {
    static constexpr std::string_view name = "bit", about = "a bit is flipped", source = "thesis 1.1";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::binary; }

    double probability = 0.01;
    void operator()(std::span<Genome> population, RandomStream& random) const;
};

/// Flips bits with the same distribution as BitMutation, but with fewer draws. Draws the distance from one flipped bit
/// to the next, which is geometrically distributed, until a distance leads past the end of the population. So it draws
/// one number for each flipped bit, and one more at the end. REQUIRES: all strings have the same length.
struct DistanceMutation {
    static constexpr std::string_view name = "distance",
                                      about = "bits are flipped as by bit mutation, but a random number is drawn only "
                                              "for the distance to the next flipped bit",
                                      source = "thesis 1.1, with other random draws";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::binary; }

    double probability = 0.01;
    void operator()(std::span<Genome> population, RandomStream& random) const;
};

/// Adds a normal deviate to the number. A sum outside the number's range is replaced by the nearest end of the range.
/// Draws two random numbers.
struct GaussianMutation {
    static constexpr std::string_view name = "gaussian",
                                      about = "a normal deviate is added; its standard deviation is `deviation` times "
                                              "the width of the parameter's bounds",
                                      source = "I. Rechenberg, 1973";
    double deviation = 0.1;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"deviation", &GaussianMutation::deviation, 0, 10,
                                       "standard deviation of the step, in widths of the parameter's bounds"});
    }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const;
};

/// Adds or subtracts a step, each with probability 1/2. The step is the width of the number's range, times `range`,
/// times 2^-u, where u is uniform in 0 ... `precision`. So all orders of magnitude are equally likely (after H.
/// Mühlenbein and D. Schlierkamp-Voosen, "Predictive models for the breeder genetic algorithm", 1993). Draws two
/// random numbers.
struct BreederMutation {
    static constexpr std::string_view
        name = "breeder",
        about = "a step is added or subtracted, of any size from `range` down to `range` * 2^-precision",
        source = "H. Mühlenbein and D. Schlierkamp-Voosen, 1993";
    double range = 0.1, precision = 24;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"range", &BreederMutation::range, 0, 1, "greatest step, in widths of the parameter's bounds"},
            PolicyNumber{"precision", &BreederMutation::precision, 0, 60,
                         "the smallest step is the greatest step divided by 2 to this power"});
    }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const;
};

/// Adds a step of either sign; the sum never leaves the number's range. The larger `index` is, the likelier are small
/// steps (K. Deb and M. Goyal, "A combined genetic adaptive search (GeneAS) for engineering design", 1996). Draws one
/// random number.
struct PolynomialMutation {
    static constexpr std::string_view
        name = "polynomial",
        about = "a step within the parameter's bounds is added; a larger `index` makes it smaller",
        source = "K. Deb and M. Goyal, 1996";
    double index = 20;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"index", &PolynomialMutation::index, 0, 1000, "distribution index: how small the steps are"});
    }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const;
};

/// Replaces the number by a random number from the same range. Draws one random number.
struct UniformMutation {
    static constexpr std::string_view name = "uniform", about = "a number is replaced by a random one from its range",
                                      source = "Z. Michalewicz, 1992";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const;
};

/// Exchanges the entry at this position with the entry at another, random position. Draws one random number.
struct SwapMutation {
    static constexpr std::string_view name = "swap", about = "two elements of the permutation are exchanged",
                                      source = "not in the thesis";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::permutation; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const;
};

/// Reverses the entries from this position to another, random position. If the other position comes first, the reversed
/// part continues from the end of the string to its beginning. If the permutation is a closed tour, this changes two
/// edges. Draws one random number.
struct InversionMutation {
    static constexpr std::string_view name = "inversion",
                                      about = "the elements between two positions of the permutation are reversed",
                                      source = "the 2-opt step of G. Croes, 1958";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::permutation; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const;
};

/// A user-defined struct with a function fits(), as the policies above have, and with the call operator
///
///     void operator()(Genome& genome, std::size_t place, const Representation& representation,
///                     RandomStream& random) const;
class OwnMutation : public OwnVariation {
public:
    template <class Policy>
    explicit OwnMutation(const Policy& policy)
        : OwnVariation(policy, [policy](std::span<Genome> population, double probability,
                                        const Representation& representation, RandomStream& random) {
              mutate_places(policy, population, probability, representation, random);
          }) {}
};

/// The policy that changes strings at random.
class Mutation : public OneOf<Mutation, BitMutation, DistanceMutation, GaussianMutation, BreederMutation,
                              PolynomialMutation, UniformMutation, SwapMutation, InversionMutation, OwnMutation> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "mutation", about = "how an offspring is changed at random";

    /// Mutates each position of each string with the given probability. For each position, draws one random number to
    /// decide whether it mutates; the policy's draws follow. BitMutation and DistanceMutation decide by their own draws
    /// alone. A permutation of one place stays unchanged, without a draw. REQUIRES: fits(representation.kind()).
    void operator()(std::span<Genome> population, double probability, const Representation& representation,
                    RandomStream& random) const;
};

} // namespace placedpar
