#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// How the string that a search breeds becomes the string that a problem reads in natural binary, field by field:
/// with fewer bits, or around a point, and those in any coding of bits.
struct Recoding {
    std::vector<std::size_t> problem_bits; ///< bits of each field of the problem's string
    /// Of each field of the bred string, at most as many: the most significant ones (thesis 6.2). The problem's other
    /// bits are 0, so that a field stands for the lower end of its cell.
    std::vector<std::size_t> bits;
    Coding coding = Coding::natural; ///< coding of the bred fields
    /// Around this string of the problem (the bias point of a "fine" genetic algorithm): a field of fewer bits than the
    /// problem's counts steps of the problem from 2^(bits - 1) below it on, and stays within the field.
    std::optional<Genome> around = std::nullopt;

    /// Throws std::invalid_argument: no field, a coding without bits, another number of fields, a field of 0 or more
    /// than 63 bits, or of more than the problem's; `around` of another length than the problem's string.
    void validate() const;
    /// Length of the bred string.
    std::size_t length() const;
    /// Length of the problem's string.
    std::size_t problem_length() const;
    /// REQUIRES: validate() throws nothing, a string of length().
    Genome to_problem(const Genome& bred) const;
    std::vector<Genome> to_problem(std::span<const Genome> bred) const;
};

/// Returns the recoding that reads the problem's own string unchanged.
Recoding natural_recoding(std::vector<std::size_t> problem_bits);

} // namespace placedpar
