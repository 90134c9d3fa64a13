#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace placedpar {

// Each way exchanges characters of two mates and says how many numbers of the stream it draws for it.
// REQUIRES, everywhere: both strings of one length, 2 or more.

/// The characters 1 ... k, k uniform in 1 ... L - 1 (thesis eq. 1.1 and 1.2). One number.
struct OnePointCrossover {
    static constexpr std::string_view name = "one-point", about = "the characters before a cut (thesis 1.1)";
    static constexpr std::tuple<> numbers() { return {}; }
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// The characters between two cuts of the string closed to a ring, each pair of two of its L places equally likely.
/// Two numbers.
struct TwoPointCrossover {
    static constexpr std::string_view name = "two-point", about = "the characters between two cuts";
    static constexpr std::tuple<> numbers() { return {}; }
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// Each character with an even chance (G. Syswerda, "Uniform crossover in genetic algorithms", 1989). One number for
/// each begun half word.
struct UniformCrossover {
    static constexpr std::string_view name = "uniform", about = "each character with an even chance";
    static constexpr std::tuple<> numbers() { return {}; }
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// One-point crossover that always makes something new (thesis 6.3): parents that differ in fewer than two bits have no
/// new offspring and are no mates, and the cut lies between the first and the last bit in which the parents differ. One
/// number.
struct DifferenceCrossover {
    static constexpr std::string_view name = "by-difference",
                                      about =
                                          "a cut between bits that differ, of mates that differ in two (thesis 6.3)";
    static constexpr std::tuple<> numbers() { return {}; }
    /// REQUIRES: they differ in two bits or more.
    void operator()(Genome& a, Genome& b, RandomStream& random) const;
};

/// How two parents make two offspring. Neighbours 0 and 1, 2 and 3, ... are mates: after reproduction they are mates at
/// random already. By difference, an individual's mate is the next one behind it that differs enough and has no mate
/// yet, and changes places with its neighbour.
class Crossover : public OneOf<OnePointCrossover, TwoPointCrossover, UniformCrossover, DifferenceCrossover> {
public:
    using OneOf::OneOf;
    static Crossover named(std::string_view text) { return read<Crossover>(text); }

    /// Each pair with the given probability: one number for the chance, and the way's own. The last of an odd number
    /// has no mate, and strings of length 1 have no cut: for neither is a number drawn. REQUIRES: all strings of one
    /// length.
    void operator()(std::span<Genome> population, double probability, RandomStream& random) const;
};

} // namespace placedpar
