#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace placedpar {

/// gray_code() returns the Gray code of a number; gray_decoded() is its inverse.
constexpr std::uint64_t gray_code(std::uint64_t number) { return number ^ (number >> 1); }
constexpr std::uint64_t gray_decoded(std::uint64_t code) {
    for (unsigned shift = 1; shift < 64; shift *= 2)
        code ^= code >> shift;
    return code;
}

/// A view of a binary string whose fields (the bits of one parameter) are in Gray code. field() returns the decoded
/// number. So a problem that reads strings by field(first, count) works with natural binary and with Gray code.
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

/// The type of string that a problem reads: the string itself, or, if `gray`, a view that decodes Gray code.
template <bool gray>
using StringRead = std::conditional_t<gray, GrayCoded<Genome>, const Genome&>;

/// Returns the length of a string of `bits` bits after `dont_care` unused bits have been inserted between every two
/// neighbouring bits (thesis eq. 6.15). REQUIRES: bits > 0.
constexpr std::size_t stuffed_bits(std::size_t bits, std::size_t dont_care) { return bits + dont_care * (bits - 1); }
/// Returns the string without its unused bits. REQUIRES: genome.size() == stuffed_bits(n, dont_care) for some n > 0.
Genome unstuffed(const Genome& genome, std::size_t dont_care);

} // namespace placedpar
