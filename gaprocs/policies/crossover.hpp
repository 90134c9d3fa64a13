#pragma once

#include "gaprocs/policies/own_variation.hpp"
#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <tuple>

namespace placedpar {

// Each policy exchanges parts of two mates; its comment says how many numbers of the stream it draws. A character is a
// bit of a binary string, or a number of a real vector, whose `unit` of 64 bits is never cut. REQUIRES, everywhere:
// both strings of one length, 2 characters or more.

/// Exchanges the characters 1 ... k, k uniform in 1 ... L - 1 (thesis eq. 1.1 and 1.2). Draws one number.
struct OnePointCrossover {
    static constexpr std::string_view name = "one-point", about = "the characters before a cut",
                                      source = "thesis 1.1, eq. 1.1 and 1.2";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// Exchanges the characters between two cuts of the string closed to a ring; each pair of its L places is equally
/// likely. Draws two numbers.
struct TwoPointCrossover {
    static constexpr std::string_view name = "two-point", about = "the characters between two cuts",
                                      source = "K. De Jong, 1975";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// Exchanges each character with probability 1/2 (G. Syswerda, "Uniform crossover in genetic algorithms", 1989). Draws
/// one number for each half word begun, or for each real number.
struct UniformCrossover {
    static constexpr std::string_view name = "uniform", about = "each character with an even chance",
                                      source = "G. Syswerda, 1989";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// One-point crossover whose offspring always differ from the parents (thesis 6.3): the cut lies between the first and
/// the last bit in which the parents differ, and parents that differ in fewer than two bits are not mates. Draws one
/// number.
struct DifferenceCrossover {
    static constexpr std::string_view name = "by-difference",
                                      about = "a cut between bits that differ, of mates that differ in two",
                                      source = "thesis 6.3";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::binary; }
    /// REQUIRES: they differ in two bits or more.
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// Draws each number of each offspring uniformly from the interval between those of its parents, extended at both ends
/// by `alpha` times its length (L. Eshelman and J. Schaffer, "Real-coded genetic algorithms and interval-schemata",
/// 1993: BLX-alpha); values outside the parameter's range become its nearest end. Draws two numbers for each.
struct BlendCrossover {
    static constexpr std::string_view name = "blend",
                                      about = "numbers between the parents', and `alpha` of their distance beyond",
                                      source = "L. Eshelman and J. Schaffer, 1993";
    double alpha = 0.5;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"alpha", &BlendCrossover::alpha, 0, 10,
                                       "how far beyond its parents a child may lie, in their distances"});
    }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& a, Genome& b, const RealVector& reals, RandomStream& random) const;
};

/// Order crossover (L. Davis, "Applying adaptive algorithms to epistatic domains", 1985): an offspring keeps the places
/// between two cuts from one parent; the others follow behind them in the order of the other parent. The cuts are drawn
/// as in TwoPointCrossover. Draws two numbers.
struct OrderCrossover {
    static constexpr std::string_view name = "order",
                                      about = "a stretch of one parent, the rest in the order of the other",
                                      source = "L. Davis, 1985";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::permutation; }
    void operator()(Genome& a, Genome& b, const Permutation& permutation, RandomStream& random) const;
};

/// A struct of a program's own that has fits() as those above, and
///
///     void operator()(Genome& a, Genome& b, const Representation& representation, RandomStream& random) const;
class OwnCrossover : public OwnVariation {
public:
    template <class Policy>
    explicit OwnCrossover(const Policy& policy)
        : OwnVariation(policy, [policy](std::span<Genome> population, double probability,
                                        const Representation& representation, RandomStream& random) {
              for (std::size_t i = 0; i + 1 < population.size(); i += 2)
                  if (random.chance(probability))
                      policy(population[i], population[i + 1], representation, random);
          }) {}
};

/// The policy by which two parents make two offspring. Neighbours 0 and 1, 2 and 3, ... are mates, since their order is
/// random after reproduction. With DifferenceCrossover, an individual's mate is the next individual that differs enough
/// and has no mate yet; it is moved next to the individual.
class Crossover : public OneOf<Crossover, OnePointCrossover, TwoPointCrossover, UniformCrossover, DifferenceCrossover,
                               BlendCrossover, OrderCrossover, OwnCrossover> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "crossover", about = "how two parents make two offspring";

    /// Crosses each pair with the given probability, which draws one number in addition to those of the policy. An
    /// individual without a mate (the last of an odd number) and strings of one character stay, and draw nothing.
    /// REQUIRES: all strings of this representation, fits(representation.kind()).
    void operator()(std::span<Genome> population, double probability, const Representation& representation,
                    RandomStream& random) const;

    /// Returns all offspring that two mates can have, found by trying every outcome of the draws. Each is a vertex of
    /// the hypercube: its string read as a whole number. The parents are included if the draws can leave them
    /// unchanged. Returns an empty set if the two are not mates. REQUIRES: both binary strings of one length, 2 to 20.
    /// Throws std::invalid_argument for a policy that does not fit binary strings.
    std::set<std::uint64_t> every_offspring(const Genome& a, const Genome& b) const;
};

} // namespace placedpar
