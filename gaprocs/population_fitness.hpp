#pragma once

#include "gaprocs/fitness.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

static_assert(EIGEN_FAST_MATH == 0,
              "Eigen's square root would be approximate with AVX-512, and a population evaluated at "
              "once would differ from its individuals: compile with -DEIGEN_FAST_MATH=0");

/// The same number of several individuals, side by side.
using Lanes = Eigen::Array<double, 8, 1>;

/// fitness_term of each lane.
inline Lanes fitness_terms(double bias, const Lanes& errors) {
    // Array::max says nothing of NaN; this takes the number.
    using MaximumOfNumbers = Eigen::internal::scalar_max_op<double, double, Eigen::PropagateNumbers>;
    Lanes terms = bias - errors * errors;
    terms = terms.binaryExpr(Lanes::Constant(-fitness_term_limit), MaximumOfNumbers()).min(fitness_term_limit);
    return (terms + fitness_rounding_shift) - fitness_rounding_shift;
}

/// A problem whose error is stated as a function of its parameters, for doubles and for Lanes alike, so that several
/// individuals can be evaluated at once: `parameter(string, i)` decodes one parameter, `error_of<T>(parameters,
/// sample)` is the error, with T = double for one individual, with T = Lanes for several.
template <typename P, typename G>
concept ErrorOfParameters = requires(const P& problem, const G& genome, std::span<const Lanes> parameters,
                                     std::span<const double> sample) {
    { problem.parameters() } -> std::convertible_to<std::size_t>;
    { problem.parameter(genome, std::size_t{}) } -> std::convertible_to<double>;
    { problem.template error_of<Lanes>(parameters, sample) } -> std::convertible_to<Lanes>;
};

/// The fitness of each of the strings over the samples, several individuals at a time. The bits are those of one
/// individual after the other: every operation rounds the same way in a lane as alone (no contraction to multiply-adds,
/// see -ffp-contract in cmake/PlacedParRoom.cmake).
/// `coded(genome)` is the string as the problem shall read it. REQUIRES: fitness.size() == population.size().
template <typename P, typename Genomes, typename Samples, typename Coded>
void fitness_in_lanes(const P& problem, const Genomes& population, const Samples& samples, double bias, Coded coded,
                      std::span<double> fitness) {
    constexpr std::size_t width = Lanes::SizeAtCompileTime;
    std::vector<Lanes> parameters(problem.parameters());
    for (std::size_t first = 0; first < population.size(); first += width) {
        // What lanes past the end compute is not used; the last individual is as good as any.
        for (std::size_t lane = 0; lane < width; ++lane) {
            auto&& genome = coded(population[std::min(first + lane, population.size() - 1)]);
            for (std::size_t i = 0; i < parameters.size(); ++i)
                parameters[i][static_cast<Eigen::Index>(lane)] = problem.parameter(genome, i);
        }
        Lanes sum = Lanes::Zero();
        for (const auto& sample : samples)
            sum += fitness_terms(bias, problem.template error_of<Lanes>(std::span<const Lanes>(parameters),
                                                                        std::span<const double>(sample)));
        std::copy_n(sum.data(), std::min(width, population.size() - first), fitness.data() + first);
    }
}

} // namespace placedpar
