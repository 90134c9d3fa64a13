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

/// The loop over the lanes of a population: sums[i] is the sum over the samples of term(parameters of individual i,
/// sample), found for several individuals at once. `parameter(i, j)` is number j of the `parameters` numbers of
/// individual i; `term(std::span<const Lanes>, sample)` gives the Lanes of a sample. The bits are those of one
/// individual after the other: every operation rounds the same way in a lane as alone (no contraction to multiply-adds,
/// see -ffp-contract in cmake/PlacedParRoom.cmake).
template <typename Parameter, typename Samples, typename Term>
void sum_in_lanes(std::size_t parameters, Parameter parameter, const Samples& samples, Term term,
                  std::span<double> sums) {
    constexpr std::size_t width = Lanes::SizeAtCompileTime;
    std::vector<Lanes> values(parameters);
    for (std::size_t first = 0; first < sums.size(); first += width) {
        // Lanes past the end repeat the last individual; what they compute is not used.
        for (std::size_t lane = 0; lane < width; ++lane)
            for (std::size_t j = 0; j < parameters; ++j)
                values[j][static_cast<Eigen::Index>(lane)] = parameter(std::min(first + lane, sums.size() - 1), j);
        Lanes sum = Lanes::Zero();
        for (const auto& sample : samples)
            sum += term(std::span<const Lanes>(values), sample);
        std::copy_n(sum.data(), std::min(width, sums.size() - first), sums.data() + first);
    }
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

/// The fitness of each of the strings over the samples, the bits of one individual evaluated after the other.
/// `coded(genome)` is the string as the problem shall read it. REQUIRES: fitness.size() == population.size().
template <typename P, typename Genomes, typename Samples, typename Coded>
void fitness_in_lanes(const P& problem, const Genomes& population, const Samples& samples, double bias, Coded coded,
                      std::span<double> fitness) {
    auto parameter = [&](std::size_t i, std::size_t j) { return problem.parameter(coded(population[i]), j); };
    auto term = [&](std::span<const Lanes> parameters, const auto& sample) {
        return fitness_terms(bias, problem.template error_of<Lanes>(parameters, std::span<const double>(sample)));
    };
    sum_in_lanes(problem.parameters(), parameter, samples, term, fitness);
}

} // namespace placedpar
