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

// Each way exchanges parts of two mates and says how many numbers of the stream it draws for it. Characters are those
// of a binary string; of a real vector, whose `unit` is 64 bits that stay together, they are whole numbers. REQUIRES,
// everywhere: both strings of one length, 2 characters or more.

/// The characters 1 ... k, k uniform in 1 ... L - 1 (thesis eq. 1.1 and 1.2). One number.
struct OnePointCrossover {
    static constexpr std::string_view name = "one-point", about = "the characters before a cut",
                                      source = "thesis 1.1, eq. 1.1 and 1.2";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// The characters between two cuts of the string closed to a ring, each pair of two of its L places equally likely.
/// Two numbers.
struct TwoPointCrossover {
    static constexpr std::string_view name = "two-point", about = "the characters between two cuts",
                                      source = "K. De Jong, 1975";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// Each character with an even chance (G. Syswerda, "Uniform crossover in genetic algorithms", 1989). One number for
/// each begun half word, or for each of real numbers.
struct UniformCrossover {
    static constexpr std::string_view name = "uniform", about = "each character with an even chance",
                                      source = "G. Syswerda, 1989";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// One-point crossover that always makes something new (thesis 6.3): parents that differ in fewer than two bits have no
/// new offspring and are not mates, and the cut lies between the first and the last bit in which the parents differ.
/// One number.
struct DifferenceCrossover {
    static constexpr std::string_view name = "by-difference",
                                      about = "a cut between bits that differ, of mates that differ in two",
                                      source = "thesis 6.3";
    static constexpr std::tuple<> numbers() { return {}; }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::binary; }
    /// REQUIRES: they differ in two bits or more.
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// Each number of each offspring anew, uniform between those of its parents and a share `alpha` of their distance
/// beyond them (L. Eshelman and J. Schaffer, "Real-coded genetic algorithms and interval-schemata", 1993: BLX-alpha);
/// beyond an end of the range lies that end. Two numbers for each.
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
/// between two cuts from one parent; the others follow behind them in the order of the other parent. The cuts are as
/// those of TwoPointCrossover. Two numbers.
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

/// How two parents make two offspring. Neighbours 0 and 1, 2 and 3, ... are mates: after reproduction they are mates at
/// random already. By difference, an individual's mate is the next one behind it that differs enough and has no mate
/// yet, and changes places with its neighbour.
class Crossover : public OneOf<Crossover, OnePointCrossover, TwoPointCrossover, UniformCrossover, DifferenceCrossover,
                               BlendCrossover, OrderCrossover, OwnCrossover> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "crossover", about = "how two parents make two offspring";

    /// Each pair with the given probability: one number for the chance, and the way's own. The last of an odd number
    /// has no mate, and strings of one character have no cut: for neither is a number drawn. REQUIRES: all strings of
    /// this representation, fits(representation.kind()).
    void operator()(std::span<Genome> population, double probability, const Representation& representation,
                    RandomStream& random) const;

    /// All offspring that it can make of two mates, found by trying every outcome of its draws: vertices of the
    /// hypercube, each the string read as a whole number. The parents are among them where both can stay as they are.
    /// Returns none where the two are not mates. REQUIRES: both binary strings of one length, 2 to 20. Throws
    /// std::invalid_argument for a way that does not fit binary strings.
    std::set<std::uint64_t> every_offspring(const Genome& a, const Genome& b) const;
};

} // namespace placedpar
