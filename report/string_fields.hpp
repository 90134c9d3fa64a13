#pragma once

#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

/// A field of a string in natural binary (thesis eq. 1.5): what all its bits 0 and 1 stand for, and what a step of its
/// code changes.
struct StringField {
    std::string name, unit;
    std::size_t bits;
    double least, most;

    double step() const { return (most - least) / (static_cast<double>(std::uint64_t{1} << bits) - 1); }
    /// But for the name.
    bool is_like(const StringField& other) const;
};

/// One for each parameter; empty where the string has no fields of bits.
std::vector<StringField> string_fields(const SearchProblem& problem);

} // namespace placedpar
