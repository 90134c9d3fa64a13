#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/parameter_coding.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

namespace placedpar {

// Functions of real numbers; all are minimised. optimum() is the minimum over all real numbers, so perhaps no binary
// string has this value. F1 to F5 are K. De Jong's functions ("An analysis of the behavior of a class of genetic
// adaptive systems", 1975), by default with the number of parameters and bits that he used.

/// Base class of functions whose parameters all have the same range. `Function` is the derived class, with the range
/// from Function::low to Function::high.
template <class Function>
struct OverBox {
    std::size_t dimensions = Function::usual_dimensions;
    std::size_t bits = Function::usual_bits; ///< bits of each parameter
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"dimensions", &Function::dimensions, Function::least_dimensions, 10000,
                                       "number of parameters"},
                          PolicyNumber{"bits", &Function::bits, 1, 52, "bits of each parameter"});
    }
    static constexpr std::size_t least_dimensions = 1;
    ParameterCoding representation() const { return {dimensions, {Function::low, Function::high, bits}}; }
    std::optional<double> optimum() const { return 0; }
};

/// The sum of squares.
struct Sphere : OverBox<Sphere> {
    static constexpr std::string_view name = "sphere", about = "the sum of squares (De Jong's F1): one smooth valley";
    static constexpr std::size_t usual_dimensions = 3, usual_bits = 10;
    static constexpr double low = -5.12, high = 5.12;
    double objective(std::span<const double> x) const;
};

/// The sum of 100 (x_i^2 - x_(i+1))^2 + (1 - x_i)^2. The minimum is where all x_i are 1.
struct Rosenbrock : OverBox<Rosenbrock> {
    static constexpr std::string_view name = "rosenbrock",
                                      about = "Rosenbrock's saddle (De Jong's F2): a narrow valley that bends";
    static constexpr std::size_t usual_dimensions = 2, usual_bits = 12, least_dimensions = 2;
    static constexpr double low = -2.048, high = 2.048;
    double objective(std::span<const double> x) const;
};

/// The sum of the parameters, each rounded down. At the minimum every rounded parameter is -6.
struct StepFunction : OverBox<StepFunction> {
    static constexpr std::string_view name = "step", about = "the sum of floors (De Jong's F3): a plateau at each step";
    static constexpr std::size_t usual_dimensions = 5, usual_bits = 10;
    static constexpr double low = -5.12, high = 5.12;
    double objective(std::span<const double> x) const;
    std::optional<double> optimum() const { return -6.0 * static_cast<double>(dimensions); }
};

/// The sum of i x_i^4 plus noise, a normal deviate. De Jong draws the deviate at each evaluation. Here the deviate
/// depends only on `seed` and the parameters, so an individual has the same noise in every evaluation. The optimum is
/// unknown, unless `noise` is 0.
struct Quartic : OverBox<Quartic> {
    static constexpr std::string_view name = "quartic",
                                      about = "the sum of i x_i^4 with noise (De Jong's F4); equal strings have equal "
                                              "noise";
    static constexpr std::size_t usual_dimensions = 30, usual_bits = 8;
    static constexpr double low = -1.28, high = 1.28;
    double noise = 1; ///< standard deviation of the deviate
    std::size_t seed = 1;
    static constexpr auto numbers() {
        return std::tuple_cat(
            OverBox::numbers(),
            std::tuple(PolicyNumber{"noise", &Quartic::noise, 0, 1e6, "standard deviation of the noise"},
                       PolicyNumber{"seed", &Quartic::seed, 0, 1e15, "seed of the noise"}));
    }
    double objective(std::span<const double> x) const;
    std::optional<double> optimum() const;
};

/// Shekel's foxholes: a plain with 25 narrow holes, the deepest at (-32, -32).
struct Foxholes {
    static constexpr std::string_view name = "foxholes", about = "Shekel's 25 foxholes in a plain (De Jong's F5)";
    std::size_t bits = 17;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"bits", &Foxholes::bits, 1, 52, "bits of each of the two fields"});
    }
    ParameterCoding representation() const { return {2, {-65.536, 65.536, bits}}; }
    double objective(std::span<const double> x) const;
    /// The known optimum, to six digits.
    double optimum() const { return 0.998004; }
};

/// 10 n + the sum of x_i^2 - 10 cos(2 pi x_i).
struct Rastrigin : OverBox<Rastrigin> {
    static constexpr std::string_view name = "rastrigin",
                                      about = "Rastrigin's function: a valley at every whole number";
    static constexpr std::size_t usual_dimensions = 20, usual_bits = 16;
    static constexpr double low = -5.12, high = 5.12;
    double objective(std::span<const double> x) const;
};

/// 418.9829 n - the sum of x_i sin(sqrt(|x_i|)). The minimum, where all x_i are 420.9687, is far from the second
/// deepest valley.
struct Schwefel : OverBox<Schwefel> {
    static constexpr std::string_view name = "schwefel",
                                      about = "Schwefel's function: the best valley is far from the second best";
    static constexpr std::size_t usual_dimensions = 10, usual_bits = 16;
    static constexpr double low = -500, high = 500;
    /// The greatest value of x sin(sqrt(|x|)) in the range, and the x at which it occurs.
    static constexpr double best_term = 418.98288727243374, best_place = 420.96874635998199;
    double objective(std::span<const double> x) const;
};

/// 1 + the sum of x_i^2 / 4000 - the product of cos(x_i / sqrt(i)).
struct Griewank : OverBox<Griewank> {
    static constexpr std::string_view name = "griewank",
                                      about = "Griewank's function: a bowl with ripples that depend on all numbers";
    static constexpr std::size_t usual_dimensions = 10, usual_bits = 16;
    static constexpr double low = -600, high = 600;
    double objective(std::span<const double> x) const;
};

/// 20 + e - 20 exp(-0.2 sqrt(the mean of x_i^2)) - exp(the mean of cos(2 pi x_i)) (D. Ackley, "A Connectionist Machine
/// for Genetic Hillclimbing", 1987).
struct Ackley : OverBox<Ackley> {
    static constexpr std::string_view name = "ackley",
                                      about = "Ackley's function: a plain of small valleys around one deep hole";
    static constexpr std::size_t usual_dimensions = 10, usual_bits = 16;
    static constexpr double low = -32.768, high = 32.768;
    double objective(std::span<const double> x) const;
};

/// Rastrigin's function, computed `work` times, for measuring farms: an evaluation takes as long as the user wishes.
struct Costly : OverBox<Costly> {
    static constexpr std::string_view
        name = "costly",
        about = "Rastrigin's function, computed `work` times so that an evaluation takes as long as needed";
    static constexpr std::size_t usual_dimensions = 2, usual_bits = 16;
    static constexpr double low = -5.12, high = 5.12;
    std::size_t work = 1; ///< number of computations in each evaluation
    static constexpr auto numbers() {
        return std::tuple_cat(OverBox::numbers(), std::tuple(PolicyNumber{"work", &Costly::work, 1, 1e9,
                                                                          "number of computations of the function"}));
    }
    double objective(std::span<const double> x) const;
};

} // namespace placedpar
