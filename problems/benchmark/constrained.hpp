#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/parameter_coding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

// The first six problems with constraints of Z. Michalewicz and M. Schoenauer ("Evolutionary algorithms for constrained
// parameter optimization problems", 1996), in the form of J. Liang and others ("Problem definitions and evaluation
// criteria for the CEC 2006 special session", 2006). All are minimised. Each constraint is a number that must be at
// most 0. An equation h(x) = 0 is satisfied if |h(x)| <= 0.0001. optimum() is the best known value with this tolerance.

/// Base class of the problems. `Function` is the derived class, whose function ranges() returns the range of each
/// parameter.
template <class Function>
struct WithinRanges {
    using X = std::span<const double>;

    std::size_t bits = 30; ///< bits of each parameter
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"bits", &Function::bits, 1, 52, "bits of each parameter"});
    }
    ParameterCoding representation() const {
        std::vector<ParameterField> fields;
        for (const RealRange& range : Function::ranges())
            fields.push_back({range.low, range.high, bits});
        return ParameterCoding(std::move(fields));
    }

protected:
    static double squared(double x) { return x * x; }
    static double cubed(double x) { return x * x * x; }
    static double sum_of(X x) { return std::accumulate(x.begin(), x.end(), 0.0); }
    static double product_of(X x) { return std::accumulate(x.begin(), x.end(), 1.0, std::multiplies()); }
    static double sum_of_squares(X x) { return std::inner_product(x.begin(), x.end(), x.begin(), 0.0); }
    /// Returns the constraint of the equation h(x) = 0 for a value h of h(x).
    static double equation(double h) { return std::abs(h) - 1e-4; }
};

struct G01 : WithinRanges<G01> {
    static constexpr std::string_view name = "g01", about = "G01: 13 parameters, 9 linear constraints";
    double optimum() const { return -15; }
    static std::vector<RealRange> ranges() {
        std::vector<RealRange> all(13, {0, 1});
        std::fill(all.begin() + 9, all.begin() + 12, RealRange{0, 100});
        return all;
    }
    double objective(X x) const {
        return 5 * sum_of(x.first(4)) - 5 * sum_of_squares(x.first(4)) - sum_of(x.subspan(4));
    }
    std::vector<double> constraints(X x) const {
        return {2 * x[0] + 2 * x[1] + x[9] + x[10] - 10,
                2 * x[0] + 2 * x[2] + x[9] + x[11] - 10,
                2 * x[1] + 2 * x[2] + x[10] + x[11] - 10,
                -8 * x[0] + x[9],
                -8 * x[1] + x[10],
                -8 * x[2] + x[11],
                -2 * x[3] - x[4] + x[9],
                -2 * x[5] - x[6] + x[10],
                -2 * x[7] - x[8] + x[11]};
    }
};

struct G02 : WithinRanges<G02> {
    static constexpr std::string_view name = "g02", about = "G02: 20 parameters, many local optima, 2 constraints";
    double optimum() const { return -0.8036191; }
    static std::vector<RealRange> ranges() { return std::vector<RealRange>(20, {0, 10}); }
    double objective(X x) const {
        double fourth = 0, product = 1, weighted = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double c = std::cos(x[i]);
            fourth += squared(squared(c));
            product *= squared(c);
            weighted += static_cast<double>(i + 1) * squared(x[i]);
        }
        return -std::abs((fourth - 2 * product) / std::sqrt(weighted));
    }
    std::vector<double> constraints(X x) const {
        return {0.75 - product_of(x), sum_of(x) - 7.5 * static_cast<double>(x.size())};
    }
};

struct G03 : WithinRanges<G03> {
    static constexpr std::string_view name = "g03", about = "G03: 10 parameters; one equation puts them on a sphere";
    double optimum() const { return -1.0005001; }
    static std::vector<RealRange> ranges() { return std::vector<RealRange>(10, {0, 1}); }
    double objective(X x) const {
        const auto count = static_cast<double>(x.size());
        return -std::pow(std::sqrt(count), count) * product_of(x);
    }
    std::vector<double> constraints(X x) const { return {equation(sum_of_squares(x) - 1)}; }
};

struct G04 : WithinRanges<G04> {
    static constexpr std::string_view name = "g04", about = "G04: 5 parameters, 6 constraints";
    double optimum() const { return -30665.538672; }
    static std::vector<RealRange> ranges() { return {{78, 102}, {33, 45}, {27, 45}, {27, 45}, {27, 45}}; }
    double objective(X x) const {
        return 5.3578547 * squared(x[2]) + 0.8356891 * x[0] * x[4] + 37.293239 * x[0] - 40792.141;
    }
    std::vector<double> constraints(X x) const {
        const double u = 85.334407 + 0.0056858 * x[1] * x[4] + 0.0006262 * x[0] * x[3] - 0.0022053 * x[2] * x[4];
        const double v = 80.51249 + 0.0071317 * x[1] * x[4] + 0.0029955 * x[0] * x[1] + 0.0021813 * squared(x[2]);
        const double w = 9.300961 + 0.0047026 * x[2] * x[4] + 0.0012547 * x[0] * x[2] + 0.0019085 * x[2] * x[3];
        return {u - 92, -u, v - 110, 90 - v, w - 25, 20 - w};
    }
};

struct G05 : WithinRanges<G05> {
    static constexpr std::string_view name = "g05", about = "G05: 4 parameters, 2 constraints and 3 equations";
    double optimum() const { return 5126.496714; }
    static std::vector<RealRange> ranges() { return {{0, 1200}, {0, 1200}, {-0.55, 0.55}, {-0.55, 0.55}}; }
    double objective(X x) const { return 3 * x[0] + 0.000001 * cubed(x[0]) + 2 * x[1] + 0.000002 / 3 * cubed(x[1]); }
    std::vector<double> constraints(X x) const {
        return {x[2] - x[3] - 0.55, x[3] - x[2] - 0.55,
                equation(1000 * std::sin(-x[2] - 0.25) + 1000 * std::sin(-x[3] - 0.25) + 894.8 - x[0]),
                equation(1000 * std::sin(x[2] - 0.25) + 1000 * std::sin(x[2] - x[3] - 0.25) + 894.8 - x[1]),
                equation(1000 * std::sin(x[3] - 0.25) + 1000 * std::sin(x[3] - x[2] - 0.25) + 1294.8)};
    }
};

struct G06 : WithinRanges<G06> {
    static constexpr std::string_view name = "g06", about = "G06: 2 parameters in a narrow crescent";
    double optimum() const { return -6961.813876; }
    static std::vector<RealRange> ranges() { return {{13, 100}, {0, 100}}; }
    double objective(X x) const { return cubed(x[0] - 10) + cubed(x[1] - 20); }
    std::vector<double> constraints(X x) const {
        return {100 - squared(x[0] - 5) - squared(x[1] - 5), squared(x[0] - 6) + squared(x[1] - 5) - 82.81};
    }
};

} // namespace placedpar
