#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// Converts each field of the string that a search breeds to a field of the string that a problem reads in natural
/// binary. The bred fields may have fewer bits, may be relative to a point, and may be in any coding of bits.
struct Recoding {
    std::vector<std::size_t> problem_bits; ///< bits of each field of the problem's string
    /// Bits of each field of the bred string, at most the number of bits of the problem's field. Without `around`, they
    /// are the field's most significant bits (thesis 6.2). The problem's other bits are 0.
    std::vector<std::size_t> bits;
    Coding coding = Coding::natural; ///< coding of the bred fields
    /// A string of the problem, which is the bias point of a "fine" genetic algorithm. A bred field with all bits of
    /// the problem's field ignores this point. A field with fewer bits counts steps of the problem's field. It counts
    /// from 2^(bits - 1) steps below this point, and the result is limited to the problem's range.
    std::optional<Genome> around = std::nullopt;

    /// Throws std::invalid_argument if there are no fields, if the coding has no bits, or if `bits` and `problem_bits`
    /// have different lengths. Throws it also if a field has 0 bits, more than 63 bits, or more bits than the problem's
    /// field. Throws it also if `around` does not have the length of the problem's string.
    void validate() const;
    /// Returns the length of the bred string in bits.
    std::size_t length() const;
    /// Returns the length of the problem's string in bits.
    std::size_t problem_length() const;
    /// Returns the problem's string. REQUIRES: validate() throws nothing, and the bred string has length().
    Genome to_problem(const Genome& bred) const;
    std::vector<Genome> to_problem(std::span<const Genome> bred) const;
};

/// Returns the recoding that leaves the problem's string unchanged.
Recoding natural_recoding(std::vector<std::size_t> problem_bits);

} // namespace placedpar
