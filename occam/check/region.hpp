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

/// A subscript, a field or a segment in the path from a variable to the part that is used.
struct PathStep {
    const Expression* index = nullptr; ///< the subscript, or the start of a segment; null for start 0 and for a field
    const Expression* count = nullptr; ///< count of a segment; null if the segment extends to the end
    bool is_segment = false;
    std::optional<std::uint32_t> field = {};

    bool operator==(const PathStep&) const = default;
};

/// A use of a variable or channel.
struct Access {
    AccessKind kind{};
    Place at;
    const Declaration* root = nullptr; ///< the declaration named at this place
    const Declaration* base = nullptr; ///< the variable, channel or RETYPES of which a part is accessed
    std::vector<PathStep> steps = {};  ///< path from the base
    const Declaration* through =
        nullptr;                  ///< the called routine whose body makes the access; null if the place itself does
    bool is_abbreviation = false; ///< the declaration of an abbreviation, which only names it
};

/// Values of the indices of replicators.
using IndexValues = std::unordered_map<const Declaration*, std::int64_t>;
/// The replicators of a program, by their index.
using Replicators = std::unordered_map<const Declaration*, const Replicator*>;

/// Elements of a variable, counted through all dimensions: from `first`, before `end`.
struct Region {
    std::int64_t first = 0, end = 0;
    bool is_exact = true; ///< if false, an unknown part of the region is used
};
enum class Overlap : std::uint8_t { none, possible, certain };

/// Returns the value of an integer expression, if it depends only on constants and on these indices.
std::optional<std::int64_t> value_of(const Expression&, const IndexValues&);
/// Adds the indices of replicators on which an access depends, in the order of the text.
void add_indices(const Access&, std::vector<const Declaration*>& indices);
Region region_of(const Access&, const IndexValues&);
/// Returns how two regions of one variable meet.
Overlap overlap_of(const Region&, const Region&);
/// Returns how two accesses to one variable meet, for some values of the replicators around them.
Overlap overlap_of(const Access&, const Access&, const Replicators&);

/// Calls a function with values of the indices, at most `most` times; an index whose replicator is not known at compile
/// time gets no value. Stops when the function returns false.
void for_each_value(const std::vector<const Declaration*>& indices, const Replicators&, std::size_t most,
                    IndexValues& values, const std::function<bool(const IndexValues&)>&);

} // namespace placedpar::occam
