#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// Converts the string that a search breeds to the string that a problem reads in natural binary, field by field. The
/// bred fields may have fewer bits, may be relative to a point, and may be in any coding of bits.
struct Recoding {
    std::vector<std::size_t> problem_bits; ///< bits of each field of the problem's string
    /// Bits of each field of the bred string, at most as many as in the problem. Without `around` they are the field's
    /// most significant bits (thesis 6.2); the problem's other bits are 0, so that the field stands for the lower end
    /// of its cell.
    std::vector<std::size_t> bits;
    Coding coding = Coding::natural; ///< coding of the bred fields
    /// A string of the problem, the bias point of a "fine" genetic algorithm. A bred field with fewer bits than the
    /// problem's counts the problem's steps from 2^(bits - 1) steps below this point, limited to the problem's range.
    std::optional<Genome> around = std::nullopt;

    /// Throws std::invalid_argument: no field, a coding without bits, another number of fields, a field of 0 or more
    /// than 63 bits, or of more than the problem's; `around` of another length than the problem's string.
    void validate() const;
    /// Length of the bred string.
    std::size_t length() const;
    /// Length of the problem's string.
    std::size_t problem_length() const;
    /// Returns the problem's string. REQUIRES: validate() throws nothing; a string of length().
    Genome to_problem(const Genome& bred) const;
    std::vector<Genome> to_problem(std::span<const Genome> bred) const;
};

/// Returns the recoding whose bred string is the problem's own string, unchanged.
Recoding natural_recoding(std::vector<std::size_t> problem_bits);

} // namespace placedpar
