#pragma once

#include "occam/language/tree.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace placedpar::occam {

enum class AccessKind : std::uint8_t { read, write, input, output };

/// Describes one step in the path from a variable to the part that is used: a subscript, a field or a segment.
struct PathStep {
    const Expression* index = nullptr; ///< the subscript, or the start of a segment; null for start 0 and for a field
    const Expression* count = nullptr; ///< count of a segment; null if the segment extends to the end
    bool is_segment = false;
    std::optional<std::uint32_t> field = {};

    bool operator==(const PathStep&) const = default;
};

/// Describes a use of a variable or channel.
struct Access {
    AccessKind kind{};
    Place at;
    const Declaration* root = nullptr; ///< the declaration named at this place
    const Declaration* base =
        nullptr;                      ///< the variable, channel or RETYPES from which `steps` lead to the accessed part
    std::vector<PathStep> steps = {}; ///< path from the base to the accessed part
    const Declaration* through =
        nullptr; ///< the called routine whose body makes the access; null if no routine is called
    bool is_abbreviation =
        false; ///< the place declares an abbreviation, which names the variable without using its value
};

/// Holds values of the indices of replicators.
using IndexValues = std::unordered_map<const Declaration*, std::int64_t>;
/// Holds the replicators of a program, by the declarations of their indices.
using Replicators = std::unordered_map<const Declaration*, const Replicator*>;

/// Holds a range of elements of a variable, from `first` to the one before `end`. Elements are counted through all
/// dimensions.
struct Region {
    std::int64_t first = 0, end = 0;
    bool is_exact = true; ///< false if only a part of the region is used, and this part is unknown
};
enum class Overlap : std::uint8_t { none, possible, certain };

/// Returns the value of an integer expression, if it depends only on constants and on these indices.
std::optional<std::int64_t> value_of(const Expression&, const IndexValues&);
/// Adds the indices of replicators on which an access depends, in the order of the text.
void add_indices(const Access&, std::vector<const Declaration*>& indices);
Region region_of(const Access&, const IndexValues&);
/// Returns whether two regions of one variable overlap.
Overlap overlap_of(const Region&, const Region&);
/// Returns whether two accesses to one variable can overlap, whatever values the indices of the replicators around them
/// have.
Overlap overlap_of(const Access&, const Access&, const Replicators&);

/// Calls a function with each combination of values of the indices, at most `most` times. An index has no value if its
/// replicator is not known at compile time. Stops when the function returns false.
void for_each_value(const std::vector<const Declaration*>& indices, const Replicators&, std::size_t most,
                    IndexValues& values, const std::function<bool(const IndexValues&)>&);

} // namespace placedpar::occam
