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

// Each policy below is one way to turn two mates into two offspring. The comment of each policy states how many random
// numbers the policy draws. A character is a bit of a binary string (`unit` is 1) or a number of a real vector (`unit`
// is 64 bits). Crossover never separates the bits of a character. REQUIRES of every policy: both strings have the same
// length, at least 2 characters.

/// Exchanges the first k of L characters, where k is uniform in 1 ... L - 1 (thesis eq. 1.1 and 1.2). Draws one random
/// number.
struct OnePointCrossover {
    static constexpr std::string_view name = "one-point", about = "mates exchange the characters before a cut",
                                      source = "thesis 1.1, eq. 1.1 and 1.2";
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// Exchanges the characters between two cuts. The string is a ring for this purpose, so a cut may be before any
/// character, also before the first. Each pair of cuts is equally likely. Draws two random numbers.
struct TwoPointCrossover {
    static constexpr std::string_view name = "two-point", about = "mates exchange the characters between two cuts",
                                      source = "K. De Jong, 1975";
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// Exchanges each character with probability 1/2 (G. Syswerda, "Uniform crossover in genetic algorithms", 1989). Draws
/// ceil(L / 32) random numbers for a binary string of L bits, and one for each number of a real vector.
struct UniformCrossover {
    static constexpr std::string_view name = "uniform", about = "mates exchange each character with probability 1/2",
                                      source = "G. Syswerda, 1989";
    static constexpr bool fits(StringKind kind) { return kind != StringKind::permutation; }
    void operator()(Genome& a, Genome& b, RandomStream& random, std::size_t unit = 1) const;
};

/// One-point crossover whose offspring always differ from the parents (thesis 6.3). The cut lies between the first and
/// the last bit in which the parents differ. Parents that differ in fewer than two bits cannot be mates. Draws one
/// random number.
struct DifferenceCrossover {
    static constexpr std::string_view
        name = "by-difference",
        about = "the cut is between bits in which the mates differ; mates differ in at least two bits",
        source = "thesis 6.3";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::binary; }
    /// REQUIRES: the strings differ in at least two bits.
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// Draws each number of each offspring uniformly from an interval. The interval between the parents' numbers is
/// extended at both ends by `alpha` times its length (L. Eshelman and J. Schaffer, "Real-coded genetic algorithms and
/// interval-schemata", 1993: BLX-alpha). A drawn number outside the parameter's range is replaced by the nearest end of
/// the range. Draws two random numbers for each number of the vector.
struct BlendCrossover {
    static constexpr std::string_view name = "blend",
                                      about = "the offspring's numbers are between the parents' numbers, or outside by "
                                              "at most `alpha` times the parents' distance",
                                      source = "L. Eshelman and J. Schaffer, 1993";
    double alpha = 0.5;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{
            "alpha", &BlendCrossover::alpha, 0, 10,
            "how far outside the parents' numbers an offspring's number may be; unit: the parents' distance"});
    }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& a, Genome& b, const RealVector& reals, RandomStream& random) const;
};

/// Simulated binary crossover (K. Deb and R. Agrawal, "Simulated binary crossover for continuous search space", 1995),
/// in the form for bounded parameters (K. Deb and A. Kumar, 1995). Each number is crossed with probability 1/2. The two
/// offspring's numbers are then on either side of the middle of the parents' numbers, between these numbers or outside.
/// The larger `index` is, the nearer the offspring are to the parents. Draws one random number for each number of the
/// vector, and two more if this number is crossed and differs between the parents.
struct SimulatedBinaryCrossover {
    static constexpr std::string_view name = "sbx",
                                      about = "simulated binary crossover: the offspring's numbers are near the "
                                              "parents' numbers; a larger `index` makes them nearer",
                                      source = "K. Deb and R. Agrawal, 1995";
    double index = 15;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"index", &SimulatedBinaryCrossover::index, 0, 1000,
                                       "distribution index: how near the offspring are to the parents"});
    }
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& a, Genome& b, const RealVector& reals, RandomStream& random) const;

private:
    double spread(double distance, double room, double turn) const;
};

/// Order crossover (L. Davis, "Applying adaptive algorithms to epistatic domains", 1985). An offspring takes the
/// entries between two cuts from one parent. The missing entries follow, in the order that they have in the other
/// parent. Draws two random numbers for the cuts, as TwoPointCrossover does.
struct OrderCrossover {
    static constexpr std::string_view
        name = "order",
        about = "an offspring copies a part of one parent, and takes the rest in the order of the other parent",
        source = "L. Davis, 1985";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::permutation; }
    void operator()(Genome& a, Genome& b, const Permutation& permutation, RandomStream& random) const;
};

/// A user-defined struct with a function fits(), as the policies above have, and with the call operator
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

/// The policy by which two parents produce two offspring. The mates are individuals 0 and 1, 2 and 3, and so on. These
/// pairs are random, because the selection of parents has put the population in random order. With DifferenceCrossover,
/// the mate of an individual is the next unmated individual that differs in at least two bits. This mate is moved to
/// the place after the individual.
class Crossover : public OneOf<Crossover, OnePointCrossover, TwoPointCrossover, UniformCrossover, DifferenceCrossover,
                               BlendCrossover, SimulatedBinaryCrossover, OrderCrossover, OwnCrossover> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "crossover", about = "how two parents make two offspring";

    /// Crosses each pair of mates with the given probability. For each pair, draws one random number to decide whether
    /// the pair is crossed; the policy's draws follow. In a population of odd size, the last individual stays
    /// unchanged, without a draw. Strings of one character also stay unchanged, without a draw. An individual for which
    /// DifferenceCrossover finds no mate stays unchanged. REQUIRES: all strings belong to `representation`, and
    /// fits(representation.kind()).
    void operator()(std::span<Genome> population, double probability, const Representation& representation,
                    RandomStream& random) const;

    /// Returns all offspring that two mates can have, for pictures of the search space. Each offspring is a vertex of
    /// the hypercube, that is, the whole number with the same binary digits. A parent is included if the crossover can
    /// leave it unchanged. Returns an empty set if `a` and `b` cannot be mates. REQUIRES: `a` and `b` are binary
    /// strings of the same length, 2 to 20 bits. Throws std::invalid_argument for a policy that does not fit binary
    /// strings.
    std::set<std::uint64_t> every_offspring(const Genome& a, const Genome& b) const;
};

} // namespace placedpar
