#pragma once

#include "problems/benchmark/functions.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

// Problems with two objectives, both minimised (E. Zitzler, K. Deb and L. Thiele, "Comparison of multiobjective
// evolutionary algorithms: empirical results", 2000). The Pareto front has the points whose parameters are 0 except
// x_1, which is also the first objective f_1.

/// Base class of the problems. `Function` is the derived class. Its second(f, g) is the second objective, a function of
/// the first objective f and of g = distance(). On the front g is 1; with the distance from the front g grows.
template <class Function>
struct Zdt : OverBox<Function> {
    static constexpr std::size_t usual_dimensions = 30, usual_bits = 30, least_dimensions = 2;
    static constexpr double low = 0, high = 1;
    std::optional<double> optimum() const { return std::nullopt; }
    std::vector<std::string> objective_names() const { return {"f_1", "f_2"}; }
    std::vector<double> objectives(std::span<const double> x) const {
        return {x[0], Function::second(x[0], Function::distance(x.subspan(1)))};
    }
    /// Returns 1 + 9 times the mean of the parameters after the first.
    static double distance(std::span<const double> x) {
        return 1 + 9 * std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    }
};

struct Zdt1 : Zdt<Zdt1> {
    static constexpr std::string_view name = "zdt1", about = "ZDT1: two objectives, a convex front";
    static double second(double f, double g) { return g * (1 - std::sqrt(f / g)); }
};

struct Zdt2 : Zdt<Zdt2> {
    static constexpr std::string_view name = "zdt2", about = "ZDT2: two objectives, a front that is not convex";
    static double second(double f, double g) { return g * (1 - f / g * (f / g)); }
};

struct Zdt3 : Zdt<Zdt3> {
    static constexpr std::string_view name = "zdt3", about = "ZDT3: two objectives, a front in five parts";
    static double second(double f, double g) {
        return g * (1 - std::sqrt(f / g) - f / g * std::sin(10 * std::numbers::pi * f));
    }
};

/// The first parameter is from 0 to 1, each other parameter from -5 to 5. With 10 parameters there are 21^9 local
/// fronts.
struct Zdt4 : Zdt<Zdt4> {
    static constexpr std::string_view name = "zdt4", about = "ZDT4: two objectives, very many local fronts";
    static constexpr std::size_t usual_dimensions = 10;
    ParameterCoding representation() const {
        std::vector<ParameterField> fields(dimensions, {-5, 5, bits});
        fields.front() = {0, 1, bits};
        return ParameterCoding(std::move(fields));
    }
    static double second(double f, double g) { return Zdt1::second(f, g); }
    static double distance(std::span<const double> x) {
        double sum = 1 + 10 * static_cast<double>(x.size());
        for (double each : x)
            sum += each * each - 10 * std::cos(4 * std::numbers::pi * each);
        return sum;
    }
};

} // namespace placedpar
