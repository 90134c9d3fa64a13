#pragma once

#include "explore/generate/topology_request.hpp"

#include <cstddef>
#include <string>

namespace placedpar::generate {

/// Returns the number of processors that the option --size gives for a one-dimensional topology. Throws UserError
/// unless --size is a number from `least` to `most_processors`.
std::size_t count_of(const TopologyRequest&, std::size_t least);

/// The size of a two-dimensional topology: 4 and 4 for --size 4x4.
struct Grid {
    std::size_t rows = 0, columns = 0;
};
/// Returns the size. Throws UserError unless there are at least `least_rows` rows, at least `least_columns` columns,
/// and at most `most_processors` processors.
Grid grid_of(const TopologyRequest&, std::size_t least_rows, std::size_t least_columns);

/// The size of a mesh of three dimensions, whose nodes have two processors each: 2, 3 and 4 for --size 2x3x4.
struct Box {
    std::size_t planes = 0, rows = 0, columns = 0;
};
bool has_three_dimensions(const TopologyRequest&);
/// REQUIRES: has_three_dimensions(). Throws UserError unless each number is at least 1, and the number of processors is
/// at most `most_processors`.
Box box_of(const TopologyRequest&);

/// Returns the product of the numbers that --size gives.
std::size_t product_of_size(const TopologyRequest&);

/// Throws UserError with a text such as "ring of size 7: " and the reason.
[[noreturn]] void refuse_size(const TopologyRequest&, const std::string& why);

} // namespace placedpar::generate
