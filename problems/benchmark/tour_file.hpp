#pragma once

#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace placedpar {

/// The travelling salesman problem, the shortest closed tour through all cities, with a table of distances. Distances
/// need not be equal in both directions.
class TableTour {
public:
    /// `distances` has a row for each city, with the distances to all cities. REQUIRES: places * places distances.
    TableTour(std::size_t places, std::vector<std::int32_t> distances)
        : places_(places), distances_(std::move(distances)) {}

    Permutation representation() const { return Permutation(places_); }
    /// Returns the length of the tour that visits the cities in this order and ends at the first city.
    double objective(std::span<const std::size_t> order) const;

private:
    std::size_t places_;
    std::vector<std::int32_t> distances_;
};

/// Reads a file of TSPLIB (G. Reinelt, "TSPLIB 95", 1995). TYPE must be TSP or ATSP. EDGE_WEIGHT_TYPE must be EUC_2D,
/// CEIL_2D, GEO, ATT, or EXPLICIT with the format FULL_MATRIX, UPPER_ROW, LOWER_ROW, UPPER_DIAG_ROW or LOWER_DIAG_ROW.
/// Distances are whole numbers, rounded as TSPLIB prescribes. City 1 of the file is place 0 of the permutation. Throws
/// UserError, with file and line, for anything else. Throws UserError also for more than 5000 cities, because a table
/// for 5000 cities takes 100 MB.
TableTour read_tour_file(const std::filesystem::path&);

} // namespace placedpar
