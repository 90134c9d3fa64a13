#include "problems/benchmark/constrained.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

constexpr double equation_tolerance = 1e-4;

double squared(double x) { return x * x; }
double cubed(double x) { return x * x * x; }

double sum_of_squares(std::span<const double> x) {
    double sum = 0;
    for (double each : x)
        sum += each * each;
    return sum;
}

double product_of(std::span<const double> x) {
    double product = 1;
    for (double each : x)
        product *= each;
    return product;
}

double sum_from(std::span<const double> x) {
    double sum = 0;
    for (double each : x)
        sum += each;
    return sum;
}

double equation(double h) { return std::abs(h) - equation_tolerance; }

} // namespace

std::vector<RealRange> G01::ranges() {
    std::vector<RealRange> all(13, {0, 1});
    std::fill(all.begin() + 9, all.begin() + 12, RealRange{0, 100});
    return all;
}

double G01::objective(std::span<const double> x) const {
    return 5 * sum_from(x.first(4)) - 5 * sum_of_squares(x.first(4)) - sum_from(x.subspan(4));
}

std::vector<double> G01::constraints(std::span<const double> x) const {
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

std::vector<RealRange> G02::ranges() { return std::vector<RealRange>(20, {0, 10}); }

double G02::objective(std::span<const double> x) const {
    double fourth = 0, product = 1, weighted = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double c = std::cos(x[i]);
        fourth += squared(squared(c));
        product *= squared(c);
        weighted += static_cast<double>(i + 1) * squared(x[i]);
    }
    return -std::abs((fourth - 2 * product) / std::sqrt(weighted));
}

std::vector<double> G02::constraints(std::span<const double> x) const {
    return {0.75 - product_of(x), sum_from(x) - 7.5 * static_cast<double>(x.size())};
}

std::vector<RealRange> G03::ranges() { return std::vector<RealRange>(10, {0, 1}); }

double G03::objective(std::span<const double> x) const {
    const auto count = static_cast<double>(x.size());
    return -std::pow(std::sqrt(count), count) * product_of(x);
}

std::vector<double> G03::constraints(std::span<const double> x) const { return {equation(sum_of_squares(x) - 1)}; }

std::vector<RealRange> G04::ranges() { return {{78, 102}, {33, 45}, {27, 45}, {27, 45}, {27, 45}}; }

double G04::objective(std::span<const double> x) const {
    return 5.3578547 * squared(x[2]) + 0.8356891 * x[0] * x[4] + 37.293239 * x[0] - 40792.141;
}

std::vector<double> G04::constraints(std::span<const double> x) const {
    const double u = 85.334407 + 0.0056858 * x[1] * x[4] + 0.0006262 * x[0] * x[3] - 0.0022053 * x[2] * x[4];
    const double v = 80.51249 + 0.0071317 * x[1] * x[4] + 0.0029955 * x[0] * x[1] + 0.0021813 * squared(x[2]);
    const double w = 9.300961 + 0.0047026 * x[2] * x[4] + 0.0012547 * x[0] * x[2] + 0.0019085 * x[2] * x[3];
    return {u - 92, -u, v - 110, 90 - v, w - 25, 20 - w};
}

std::vector<RealRange> G05::ranges() { return {{0, 1200}, {0, 1200}, {-0.55, 0.55}, {-0.55, 0.55}}; }

double G05::objective(std::span<const double> x) const {
    return 3 * x[0] + 0.000001 * cubed(x[0]) + 2 * x[1] + 0.000002 / 3 * cubed(x[1]);
}

std::vector<double> G05::constraints(std::span<const double> x) const {
    const double third = -x[2], fourth = -x[3];
    return {x[2] - x[3] - 0.55, x[3] - x[2] - 0.55,
            equation(1000 * std::sin(third - 0.25) + 1000 * std::sin(fourth - 0.25) + 894.8 - x[0]),
            equation(1000 * std::sin(x[2] - 0.25) + 1000 * std::sin(x[2] - x[3] - 0.25) + 894.8 - x[1]),
            equation(1000 * std::sin(x[3] - 0.25) + 1000 * std::sin(x[3] - x[2] - 0.25) + 1294.8)};
}

std::vector<RealRange> G06::ranges() { return {{13, 100}, {0, 100}}; }

double G06::objective(std::span<const double> x) const { return cubed(x[0] - 10) + cubed(x[1] - 20); }

std::vector<double> G06::constraints(std::span<const double> x) const {
    return {100 - squared(x[0] - 5) - squared(x[1] - 5), squared(x[0] - 6) + squared(x[1] - 5) - 82.81};
}

} // namespace placedpar
