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

/// Describes one step from a variable to the part of it that a program uses: a subscript, a field or a segment.
struct PathStep {
    const Expression* index = nullptr; ///< subscript, or start of a segment; null for a start of 0 and for a field
    const Expression* count = nullptr; ///< count of a segment; null if the segment extends to the end
    bool is_segment = false;
    std::optional<std::uint32_t> field = {};

    bool operator==(const PathStep&) const = default;
};

/// Describes a use of a variable or channel in a program. The functions below find out whether two uses can concern the
/// same elements of an array, for the check of parallel usage.
struct Access {
    AccessKind kind{};
    Place at;
    const Declaration* root = nullptr; ///< the declaration whose name is in the text at this place
    const Declaration* base =
        nullptr; ///< the variable, channel or RETYPES to which the name leads through abbreviations
    std::vector<PathStep> steps = {}; ///< path from the base to the accessed part
    const Declaration* through =
        nullptr; ///< the routine that is called at this place, if the access is in its body; null otherwise
    bool is_abbreviation = false; ///< the access is only the declaration of an abbreviation, which names the variable
                                  ///< without using its value
};

/// Holds values of the indices of replicators, by the declarations of the indices.
using IndexValues = std::unordered_map<const Declaration*, std::int64_t>;
/// Holds the replicators of a program, by the declarations of their indices.
using Replicators = std::unordered_map<const Declaration*, const Replicator*>;

/// Holds a range of elements of a variable: from `first` up to, but without, `end`. Elements are counted through all
/// dimensions of an array.
struct Region {
    std::int64_t first = 0, end = 0;
    bool is_exact = true; ///< false if the use concerns only an unknown part of the region
};
enum class Overlap : std::uint8_t { none, possible, certain };

/// Returns the value of an integer expression; nothing if the expression contains other names than constants and these
/// indices.
std::optional<std::int64_t> value_of(const Expression&, const IndexValues&);
/// Adds to `indices` the indices of replicators in the subscripts of an access, in the order of the text.
void add_indices(const Access&, std::vector<const Declaration*>& indices);
Region region_of(const Access&, const IndexValues&);
/// Returns whether two regions of one variable overlap.
Overlap overlap_of(const Region&, const Region&);
/// Returns whether two accesses to one variable overlap, for unknown values of the indices of their replicators.
Overlap overlap_of(const Access&, const Access&, const Replicators&);

/// Calls a function with each combination of values of the indices, at most `most` times. Stops when the function
/// returns false. `values` has the present combination. An index is not in `values` if the base, count or step of its
/// replicator is unknown at compile time.
void for_each_value(const std::vector<const Declaration*>& indices, const Replicators&, std::size_t most,
                    IndexValues& values, const std::function<bool(const IndexValues&)>&);

} // namespace placedpar::occam
