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

/// The kind of elements that a string has. The kind determines which crossovers and mutations work on the string.
enum class StringKind : unsigned char { binary, real, permutation };

/// Returns "binary strings", "real vectors" or "permutations".
std::string_view name_of(StringKind);

// A representation says what the bits of a string stand for. Each class below has bits(), the length of the string, and
// decode(), which returns what the string codes. Every string is a Genome, so code that only passes strings on need not
// know their kind. A real number or an entry of a permutation takes 64 bits.

/// A binary string that the problem itself interprets.
class BitString {
public:
    /// Throws std::invalid_argument for 0 bits.
    explicit BitString(std::size_t bits);

    std::size_t bits() const { return bits_; }
    const Genome& decode(const Genome& genome) const { return genome; }

private:
    std::size_t bits_;
};

/// A range that includes both ends.
struct RealRange {
    double low = 0, high = 1;
};

/// A vector of real numbers, each with its own range.
class RealVector {
public:
    /// Throws std::invalid_argument if there are no ranges, and unless each range has finite ends, `low` < `high` and a
    /// finite width.
    explicit RealVector(std::vector<RealRange> ranges);
    /// Makes a vector whose numbers all have the same range.
    RealVector(std::size_t numbers, RealRange each) : RealVector(std::vector<RealRange>(numbers, each)) {}

    std::size_t parameters() const { return ranges_.size(); }
    const RealRange& range(std::size_t number) const { return ranges_[number]; }
    std::size_t bits() const { return 64 * ranges_.size(); }

    // REQUIRES of the next three functions: a string of bits() bits.
    double value(const Genome& genome, std::size_t number) const;
    /// Sets a number. A value outside the number's range is replaced by the nearest end of the range.
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

    /// REQUIRES: a string of bits() bits.
    std::vector<std::size_t> decode(const Genome& genome) const;
    /// REQUIRES: order.size() == places().
    Genome encode(std::span<const std::size_t> order) const;

private:
    std::size_t places_;
};

/// Holds one of the representations above.
class Representation {
public:
    Representation(BitString bits) : of_(bits) {}
    Representation(RealVector reals) : of_(std::move(reals)) {}
    Representation(Permutation permutation) : of_(permutation) {}

    StringKind kind() const { return static_cast<StringKind>(of_.index()); }
    std::size_t bits() const;
    /// Returns the number of bits of a character: the bits that crossover keeps together.
    std::size_t unit() const { return kind() == StringKind::binary ? 1 : 64; }
    /// REQUIRES: kind() is StringKind::real for reals(), StringKind::permutation for permutation().
    const RealVector& reals() const { return std::get<RealVector>(of_); }
    const Permutation& permutation() const { return std::get<Permutation>(of_); }

    /// Returns a random string. Each bit is 1 with probability 1/2 (drawn by Genome::random()); each real number is
    /// uniform in its range (one random number); all permutations are equally likely (at least places - 1 random
    /// numbers).
    Genome random(RandomStream& random) const;
    std::vector<Genome> random_population(std::size_t count, RandomStream& random) const;

    /// Returns whether all strings belong to this representation: each has bits() bits, each real number is in its
    /// range, and each number of a permutation occurs once.
    bool holds(std::span<const Genome> strings) const;

    /// Returns the distance between two strings: for binary strings the number of bits in which they differ; for real
    /// vectors the Euclidean distance, with each number in units of the width of its range; for permutations, seen as
    /// closed tours, the number of edges of one tour that the other tour does not have. REQUIRES: both strings belong
    /// to this representation.
    double distance(const Genome& a, const Genome& b) const;

    /// Returns the string as a text, such as "01101", "0.5 -3" or "2 0 1".
    std::string text(const Genome& genome) const;
    /// Reads a string from its text. If the text is not a string of this representation, throws a UserError that says
    /// what would be right.
    Genome read(std::string_view text) const;

private:
    std::variant<BitString, RealVector, Permutation> of_; ///< in the order of StringKind
};

} // namespace placedpar
