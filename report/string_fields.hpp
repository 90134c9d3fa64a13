#pragma once

#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// Describes a field of a string in natural binary, that is, the bits that code one parameter (thesis eq. 1.5). `least`
/// is the parameter's value if all bits are 0, and `most` is its value if all bits are 1. step() is the difference
/// between the values of neighbouring codes.
struct StringField {
    std::string name, unit;
    std::size_t bits;
    double least, most;

    double step() const { return (most - least) / (static_cast<double>(std::uint64_t{1} << bits) - 1); }
    /// Returns whether both fields are equal apart from their names.
    bool is_like(const StringField& other) const;
};

/// Returns one field for each parameter; empty if the string has no fields of bits.
std::vector<StringField> string_fields(const SearchProblem& problem);

} // namespace placedpar
