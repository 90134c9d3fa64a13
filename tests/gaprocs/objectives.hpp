#pragma once

#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/policy.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>

/// The smallest possible problem.
struct PlainSphere {
    placedpar::ParameterCoding representation() const { return placedpar::ParameterCoding(3, {-4, 4, 8}); }
    double objective(std::span<const double> x) const { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; }
};

/// A problem with a name but without numbers.
struct Bowl {
    static constexpr std::string_view name = "bowl", about = "the square of the distance from 1";
    placedpar::ParameterCoding representation() const { return placedpar::ParameterCoding(1, {0, 2, 6}); }
    double objective(std::span<const double> x) const { return (x[0] - 1) * (x[0] - 1); }
};

/// A problem with all optional functions, such as the names of its parameters.
struct Valley {
    static constexpr std::string_view name = "valley", about = "a straight valley";
    std::size_t dimensions = 2;
    double low = -1;
    static constexpr auto numbers() {
        return std::tuple(placedpar::PolicyNumber{"dimensions", &Valley::dimensions, 1, 9},
                          placedpar::PolicyNumber{"low", &Valley::low, -9, 9});
    }

    placedpar::ParameterCoding representation() const { return placedpar::ParameterCoding(dimensions, {low, 1, 4}); }
    double objective(std::span<const double> x) const { return std::abs(x[0]); }
    std::vector<std::string> parameter_names() const { return {"across", "along"}; }
    std::vector<std::string> parameter_units() const { return {"m", "km"}; }
    std::string_view objective_unit() const { return "m"; }
    double optimum() const { return 0; }
};

/// A problem whose objective is x if x is allowed, and otherwise infinite or not a number.
struct Cliff {
    placedpar::ParameterCoding representation() const { return placedpar::ParameterCoding(1, {0, 4, 2}); }
    double objective(std::span<const double> x) const {
        using Limits = std::numeric_limits<double>;
        return x[0] == 1   ? Limits::quiet_NaN()
               : x[0] == 2 ? Limits::infinity()
               : x[0] == 3 ? -Limits::infinity()
                           : x[0];
    }
};

/// A problem whose objective is never a number.
struct Nowhere {
    placedpar::ParameterCoding representation() const { return placedpar::ParameterCoding(1, {0, 4, 2}); }
    double objective(std::span<const double>) const { return std::numeric_limits<double>::quiet_NaN(); }
};

/// A problem of permutations. The objective is the sum of the guests' distances from the seat with their own number.
struct Seats {
    placedpar::Permutation representation() const { return placedpar::Permutation(9); }
    double objective(std::span<const std::size_t> order) const {
        double sum = 0;
        for (std::size_t i = 0; i < order.size(); ++i)
            sum += std::abs(static_cast<double>(order[i]) - static_cast<double>(i));
        return sum;
    }
    double optimum() const { return 0; }
};

/// A problem of long binary strings. The optimum has a one at every other position.
struct Comb {
    placedpar::BitString representation() const { return placedpar::BitString(4096); }
    double objective(const placedpar::Genome& genome) const {
        double sum = 0;
        for (std::size_t i = 0; i < genome.size(); ++i)
            sum += genome.bit(i) == (i % 2 == 0);
        return sum;
    }
};

/// A problem of two real numbers, one with a far larger range.
struct Plane {
    placedpar::RealVector representation() const { return placedpar::RealVector({{-1, 1}, {0, 1e6}}); }
    double objective(std::span<const double> x) const { return std::abs(x[0] - 0.25) + std::abs(x[1] / 1e6 - 0.5); }
};
