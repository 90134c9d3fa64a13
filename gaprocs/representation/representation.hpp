#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace placedpar {

class RandomStream;

/// The kind of elements of a string, which determines how it can be crossed and mutated.
enum class StringKind : unsigned char { binary, real, permutation };

/// "binary strings", "real vectors", "permutations".
std::string_view name_of(StringKind);

// The representations. Each has bits(), the length of the string, and decode(), its meaning. Real numbers and the
// places of a permutation take 64 bits each, so that code that only passes strings on need not know their kind.

/// A binary string that a problem reads itself.
class BitString {
public:
    /// Throws std::invalid_argument for 0 bits.
    explicit BitString(std::size_t bits);

    std::size_t bits() const { return bits_; }
    const Genome& decode(const Genome& genome) const { return genome; }

private:
    std::size_t bits_;
};

/// A closed range, including both ends.
struct RealRange {
    double low = 0, high = 1;
};

/// Real numbers, each in a range of its own.
class RealVector {
public:
    /// Throws std::invalid_argument: no range, ends that are not finite numbers, or low not below high.
    explicit RealVector(std::vector<RealRange> ranges);
    /// Makes a vector of several numbers with one range.
    RealVector(std::size_t numbers, RealRange each) : RealVector(std::vector<RealRange>(numbers, each)) {}

    std::size_t parameters() const { return ranges_.size(); }
    const RealRange& range(std::size_t number) const { return ranges_[number]; }
    std::size_t bits() const { return 64 * ranges_.size(); }

    // REQUIRES, everywhere: a string of bits().
    double value(const Genome& genome, std::size_t number) const;
    /// Sets a number; a value outside the range becomes its nearest end.
    void set(Genome& genome, std::size_t number, double value) const;
    std::vector<double> decode(const Genome& genome) const;

private:
    std::vector<RealRange> ranges_;
};

/// The numbers 0 ... places - 1 in some order.
class Permutation {
public:
    /// Throws std::invalid_argument for 0 places.
    explicit Permutation(std::size_t places);

    std::size_t places() const { return places_; }
    std::size_t bits() const { return 64 * places_; }

    /// REQUIRES: a string of bits().
    std::vector<std::size_t> decode(const Genome& genome) const;
    /// REQUIRES: order.size() == places().
    Genome encode(std::span<const std::size_t> order) const;

private:
    std::size_t places_;
};

/// One of the above.
class Representation {
public:
    Representation(BitString bits) : of_(bits) {}
    Representation(RealVector reals) : of_(std::move(reals)) {}
    Representation(Permutation permutation) : of_(permutation) {}

    StringKind kind() const { return static_cast<StringKind>(of_.index()); }
    std::size_t bits() const;
    /// The bits that stay together when a string is cut.
    std::size_t unit() const { return kind() == StringKind::binary ? 1 : 64; }
    /// REQUIRES: kind() is this.
    const RealVector& reals() const { return std::get<RealVector>(of_); }
    const Permutation& permutation() const { return std::get<Permutation>(of_); }

    /// A string at random: each bit an even chance (as Genome::random), each number uniform in its range (one number of
    /// the stream), each order equally likely (places - 1 numbers at least).
    Genome random(RandomStream& random) const;
    std::vector<Genome> random_population(std::size_t count, RandomStream& random) const;

    /// Returns whether all are strings of this representation: of its length, each number in its range, each place
    /// once.
    bool holds(std::span<const Genome> strings) const;

    /// How far apart two strings are: the bits in which they differ; the Euclidean distance of numbers that are
    /// measured in their ranges; the neighbours in one closed tour that are none in the other. REQUIRES: strings of
    /// this representation.
    double distance(const Genome& a, const Genome& b) const;

    /// "01101"; "0.5 -3"; "2 0 1".
    std::string text(const Genome& genome) const;
    /// Throws UserError, saying what would be right: a text that is not a string of this representation.
    Genome read(std::string_view text) const;

private:
    std::variant<BitString, RealVector, Permutation> of_; ///< in the order of StringKind
};

} // namespace placedpar
