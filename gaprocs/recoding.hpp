#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// Says how the strings that a search breeds are converted to strings that a problem reads in natural binary. A field
/// is the bits of one parameter. A bred field may have fewer bits than the problem's field, may be relative to a bias
/// point, and may be in natural binary or Gray code.
struct Recoding {
    std::vector<std::size_t> problem_bits; ///< number of bits of each field of the problem's string
    /// Number of bits of each field of the bred string, at most the bits of the problem's field. Without `around`, the
    /// bred bits become the most significant bits of the problem's field, and its other bits are 0 (thesis 6.2).
    std::vector<std::size_t> bits;
    Coding coding = Coding::natural; ///< coding of the bred fields
    /// The bias point of a fine search, which searches only around this string of the problem. A bred field with as
    /// many bits as the problem's field ignores the bias point. A bred field with fewer bits, say n, is an offset: the
    /// bred number minus 2^(n - 1) is added to the bias point's field. A sum outside the codes of the problem's field
    /// is replaced by the nearest code.
    std::optional<Genome> around = std::nullopt;

    /// Throws std::invalid_argument if there are no fields, if the coding is "real", or if `bits` and `problem_bits`
    /// have different lengths. Throws it also if a field has 0 bits or more than 63, or if a bred field has more bits
    /// than the problem's field. Throws it also if `around` is not as long as the problem's string.
    void validate() const;
    /// Returns the length of the bred string in bits.
    std::size_t length() const;
    /// Returns the length of the problem's string in bits.
    std::size_t problem_length() const;
    /// Converts a bred string to the string that the problem reads. REQUIRES: validate() throws nothing, and
    /// bred.size() == length().
    Genome to_problem(const Genome& bred) const;
    std::vector<Genome> to_problem(std::span<const Genome> bred) const;
};

/// Returns the recoding that leaves the problem's string unchanged.
Recoding natural_recoding(std::vector<std::size_t> problem_bits);

} // namespace placedpar
