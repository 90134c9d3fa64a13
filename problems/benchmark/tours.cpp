#include "problems/benchmark/tours.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace placedpar {

namespace {

/// Returns the length of the shortest tour. In a single row or column, the tour goes to the end and back. Otherwise all
/// steps of the tour have length 1, except one diagonal step if the number of cities is odd.
double shortest_on_lattice(std::size_t rows, std::size_t columns) {
    auto cities = static_cast<double>(rows * columns);
    if (std::min(rows, columns) == 1)
        return 2 * (cities - 1);
    return rows * columns % 2 == 0 ? cities : cities - 1 + std::numbers::sqrt2;
}

} // namespace

Tour::Tour(std::vector<City> cities, std::optional<double> shortest)
    : cities_(std::move(cities)), shortest_(shortest) {}

double Tour::objective(std::span<const std::size_t> order) const {
    double length = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const City &from = cities_[order[i]], &to = cities_[order[(i + 1) % order.size()]];
        length += std::hypot(to.x - from.x, to.y - from.y);
    }
    return length;
}

Tour CircleTour::problem() const {
    std::vector<City> on_circle;
    for (std::size_t i = 0; i < cities; ++i) {
        double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(cities);
        on_circle.push_back({std::cos(angle), std::sin(angle)});
    }
    auto count = static_cast<double>(cities);
    return Tour(std::move(on_circle), cities == 1 ? 0 : 2 * count * std::sin(std::numbers::pi / count));
}

Tour LatticeTour::problem() const {
    std::vector<City> crossings;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            crossings.push_back({static_cast<double>(column), static_cast<double>(row)});
    return Tour(std::move(crossings), shortest_on_lattice(rows, columns));
}

Tour RandomTour::problem() const {
    RandomStream random(seed, "cities of a tour");
    std::vector<City> scattered;
    for (std::size_t i = 0; i < cities; ++i) {
        double x = random.uniform();
        scattered.push_back({x, random.uniform()});
    }
    return Tour(std::move(scattered));
}

} // namespace placedpar
