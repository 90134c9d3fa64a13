#pragma once

#include "explore/generate/topology_request.hpp"

#include <cstddef>
#include <string>

namespace placedpar::generate {

/// Returns the number that --size gives for a one-dimensional topology. Throws UserError unless --size is a number from
/// `least` to `most_processors`.
std::size_t count_of(const TopologyRequest&, std::size_t least);

/// The size of a two-dimensional topology: 4 and 4 for --size 4x4.
struct Grid {
    std::size_t rows = 0, columns = 0;
};
/// Returns the size. Throws UserError unless there are at least `least_rows` rows, at least `least_columns` columns,
/// and at most `most_processors` processors.
Grid grid_of(const TopologyRequest&, std::size_t least_rows, std::size_t least_columns);

/// Throws UserError with the text "size 7: " and the reason.
[[noreturn]] void refuse_size(const TopologyRequest&, const std::string& why);

} // namespace placedpar::generate
