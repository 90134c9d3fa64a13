#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace placedpar {

/// Return the Gray code of a number, and the number that has a Gray code.
constexpr std::uint64_t gray_code(std::uint64_t number) { return number ^ (number >> 1); }
constexpr std::uint64_t gray_decoded(std::uint64_t code) {
    for (unsigned shift = 1; shift < 64; shift *= 2)
        code ^= code >> shift;
    return code;
}

/// A view of a binary string whose fields are in Gray code, each field separately. A problem that reads a string by
/// field(first, count) can read a GrayCoded string without change.
template <typename G>
class GrayCoded {
public:
    /// REQUIRES: the string outlives the view.
    explicit GrayCoded(const G& genome) : genome_(genome) {}

    std::size_t size() const { return genome_.size(); }
    std::uint64_t field(std::size_t first, std::size_t count) const {
        return gray_decoded(genome_.field(first, count));
    }

private:
    const G& genome_;
};

/// The type that a problem reads: the string itself, or a view that decodes its fields from Gray code.
template <bool gray>
using StringRead = std::conditional_t<gray, GrayCoded<Genome>, const Genome&>;

/// Returns the length of a string of `bits` bits after the insertion of `dont_care` bits between every two neighbours
/// (thesis eq. 6.15). REQUIRES: bits > 0.
constexpr std::size_t stuffed_bits(std::size_t bits, std::size_t dont_care) { return bits + dont_care * (bits - 1); }
/// Returns the string without its don't-care bits. REQUIRES: genome.size() equals stuffed_bits(bits, dont_care) for
/// some number of bits.
Genome unstuffed(const Genome& genome, std::size_t dont_care);

} // namespace placedpar
