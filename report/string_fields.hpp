#pragma once

#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// Describes a field of a string in natural binary (thesis eq. 1.5): the values for all bits 0 and for all bits 1, and
/// the change of value by one step of the code.
struct StringField {
    std::string name, unit;
    std::size_t bits;
    double least, most;

    double step() const { return (most - least) / (static_cast<double>(std::uint64_t{1} << bits) - 1); }
    /// Returns whether both fields are equal except for their names.
    bool is_like(const StringField& other) const;
};

/// Returns one field for each parameter; empty if the string has no fields of bits.
std::vector<StringField> string_fields(const SearchProblem& problem);

} // namespace placedpar
