#include "problems/benchmark/functions.hpp"

#include "runtime/random.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace placedpar {

namespace {

template <class Term>
double sum_of(std::span<const double> x, Term term) {
    double sum = 0;
    for (double each : x)
        sum += term(each);
    return sum;
}

double square(double x) { return x * x; }

/// Returns a random stream that depends on `x` and `seed`. Different arguments give different streams, except if their
/// 64-bit keys collide.
RandomStream stream_of(std::span<const double> x, std::uint64_t seed) {
    for (double each : x)
        seed = (seed ^ std::bit_cast<std::uint64_t>(each)) * 0x9e3779b97f4a7c15u + (seed >> 29);
    return RandomStream(seed, "noise of the quartic");
}

/// Returns a normal deviate by the method of Box and Muller.
double normal_deviate(RandomStream random) {
    double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

/// Returns Rastrigin's function at x, with `shift` added to each number.
double rastrigin(std::span<const double> x, double shift) {
    return sum_of(x, [shift](double each) {
        const double number = each + shift;
        return 10 + number * number - 10 * std::cos(2 * std::numbers::pi * number);
    });
}

} // namespace

double Sphere::objective(std::span<const double> x) const { return sum_of(x, square); }

double Rosenbrock::objective(std::span<const double> x) const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        sum += 100 * square(x[i] * x[i] - x[i + 1]) + square(1 - x[i]);
    return sum;
}

double StepFunction::objective(std::span<const double> x) const {
    return sum_of(x, [](double each) { return std::floor(each); });
}

double Quartic::objective(std::span<const double> x) const {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        sum += static_cast<double>(i + 1) * square(square(x[i]));
    return noise > 0 ? sum + noise * normal_deviate(stream_of(x, seed)) : sum;
}

std::optional<double> Quartic::optimum() const { return noise > 0 ? std::nullopt : std::optional<double>(0); }

double Foxholes::objective(std::span<const double> x) const {
    constexpr std::array<double, 5> places{-32, -16, 0, 16, 32};
    auto sixth_power = [](double d) { return square(d * d * d); };
    double sum = 0.002;
    for (std::size_t j = 0; j < 25; ++j)
        sum += 1 / (static_cast<double>(j + 1) + sixth_power(x[0] - places[j % 5]) + sixth_power(x[1] - places[j / 5]));
    return 1 / sum;
}

double Rastrigin::objective(std::span<const double> x) const { return rastrigin(x, 0); }

double Ackley::objective(std::span<const double> x) const {
    const auto count = static_cast<double>(x.size());
    const double waves = sum_of(x, [](double each) { return std::cos(2 * std::numbers::pi * each); });
    return 20 + std::numbers::e - 20 * std::exp(-0.2 * std::sqrt(sum_of(x, square) / count)) - std::exp(waves / count);
}

/// Computes the objective many times, as an example of an expensive problem. Each computation uses the result of the
/// previous computation, so the compiler cannot leave out any computation. The previous result is multiplied by
/// `share`, which is too small to change the value.
double Costly::objective(std::span<const double> x) const {
    constexpr double share = 1e-300;
    double value = 0;
    for (std::size_t i = 0; i < work; ++i)
        value = rastrigin(x, share * value);
    return value;
}

double Schwefel::objective(std::span<const double> x) const {
    return sum_of(x, [](double each) { return best_term - each * std::sin(std::sqrt(std::abs(each))); });
}

double Griewank::objective(std::span<const double> x) const {
    double product = 1;
    for (std::size_t i = 0; i < x.size(); ++i)
        product *= std::cos(x[i] / std::sqrt(static_cast<double>(i + 1)));
    return 1 + sum_of(x, square) / 4000 - product;
}

} // namespace placedpar
