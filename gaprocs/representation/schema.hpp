#pragma once

#include "gaprocs/representation/genome.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A pattern of binary strings, one of J. Holland's schemata (thesis 6.1). '*' matches both 0 and 1: "11****11" matches
/// all strings of 8 bits that begin and end with 11.
class Schema {
public:
    /// Reads a schema from a text of '0', '1' and '*'. Throws std::invalid_argument for other characters and for an
    /// empty text.
    static Schema from_string(std::string_view text);

    std::size_t size() const { return fixed_.size(); }
    /// Returns the order O(h): the number of positions that are not '*'.
    std::size_t order() const { return difference(fixed_, Genome(size())); }
    /// Returns the defining length delta(h): the distance between the first and the last position that are not '*'; 0
    /// if fewer than two positions are not '*'.
    std::size_t defining_length() const;
    /// REQUIRES: a string of size() bits.
    bool matches(const Genome& genome) const;
    std::string to_string() const;

    friend bool operator==(const Schema&, const Schema&) = default;

private:
    Genome fixed_;  ///< 1 at each position that is not '*'
    Genome values_; ///< the schema's value at each position that is not '*'; otherwise 0
};

/// Returns the number of strings that match the schema: m(h, t) of eq. 6.2.
std::size_t count_matches(const Schema&, std::span<const Genome> population);

/// Returns all schemata of `size` positions, `order` of which are not '*', in alphabetical order ('*' first).
std::vector<Schema> schemata_of_order(std::size_t size, std::size_t order);

} // namespace placedpar
