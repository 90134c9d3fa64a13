#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

struct City {
    double x = 0, y = 0;
};

/// The travelling salesman problem: which closed tour through all cities is the shortest?
class Tour {
public:
    /// `shortest`: the length of the shortest tour, if it is known.
    explicit Tour(std::vector<City> cities, std::optional<double> shortest = std::nullopt);

    Permutation representation() const { return Permutation(cities_.size()); }
    /// Returns the length of the tour that visits the cities in this order and ends at the first city.
    double objective(std::span<const std::size_t> order) const;
    std::optional<double> optimum() const { return shortest_; }

private:
    std::vector<City> cities_;
    std::optional<double> shortest_;
};

/// Cities on a circle of radius 1; the shortest tour follows the circle.
struct CircleTour {
    static constexpr std::string_view name = "tour-circle",
                                      about = "the travelling salesman with cities on a circle of radius 1";
    std::size_t cities = 20;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"cities", &CircleTour::cities, 1, 10000, "number of cities"});
    }
    Tour problem() const;
};

/// Cities on the crossings of a square lattice of spacing 1. The length of the shortest tour is known.
struct LatticeTour {
    static constexpr std::string_view name = "tour-lattice",
                                      about = "the travelling salesman with cities on a lattice of spacing 1";
    std::size_t rows = 5, columns = 4;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"rows", &LatticeTour::rows, 1, 100, "number of rows of cities"},
                          PolicyNumber{"columns", &LatticeTour::columns, 1, 100, "number of columns of cities"});
    }
    Tour problem() const;
};

/// Cities uniformly distributed in a square of width 1. The shortest tour is unknown.
struct RandomTour {
    static constexpr std::string_view name = "tour-random",
                                      about = "the travelling salesman with random cities in a square, drawn from a "
                                              "seed";
    std::size_t cities = 20, seed = 1;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"cities", &RandomTour::cities, 1, 10000, "number of cities"},
                          PolicyNumber{"seed", &RandomTour::seed, 0, 1e15, "seed of the cities' positions"});
    }
    Tour problem() const;
};

} // namespace placedpar
