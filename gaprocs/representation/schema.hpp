#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// What several binary strings have in common: "11****11" stands for all that begin and end with 11 (thesis 6.1,
/// J. Holland's schemata). '*' is a position that may be either.
class Schema {
public:
    /// From characters '0', '1' and '*'. Throws std::invalid_argument at any other, and without any.
    static Schema from_string(std::string_view text);

    std::size_t size() const { return fixed_.size(); }
    /// O(h): positions that are not '*'.
    std::size_t order() const { return difference(fixed_, Genome(size())); }
    /// delta(h): from the first such position to the last; 0 where there are fewer than two.
    std::size_t defining_length() const;
    /// REQUIRES: a string of size().
    bool matches(const Genome& genome) const;
    std::string to_string() const;

    friend bool operator==(const Schema&, const Schema&) = default;

private:
    Genome fixed_;  ///< 1 where the position is not '*'
    Genome values_; ///< there; 0 elsewhere
};

/// How many of the strings have it: m(h, t) of eq. 6.2.
std::size_t count_matches(const Schema&, std::span<const Genome> population);

/// Returns all schemata of `size` positions with the given number of fixed ones, in alphabetical order ('*' first).
std::vector<Schema> schemata_of_order(std::size_t size, std::size_t order);

} // namespace placedpar
