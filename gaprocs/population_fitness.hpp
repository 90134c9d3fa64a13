#pragma once

#include "gaprocs/fitness.hpp"
#include "runtime/lanes.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The loop over the lanes of a population: sums[i] is the sum over the samples of term(parameters of individual i,
/// sample), found for several individuals at once. `parameters_of(i)` are the parameters of individual i, as many for
/// each; `term(std::span<const T>, sample)` gives the T of a sample, T being any Lanes. The bits are those of one
/// individual after the other: every operation rounds the same way in a lane as alone (runtime/vector_width.hpp).
template <typename ParametersOf, typename Samples, typename Term>
void sum_in_lanes(const ParametersOf& parameters_of, const Samples& samples, const Term& term, std::span<double> sums) {
    in_vectors([&]<std::size_t width>() __attribute__((flatten)) {
        using Several = Lanes<width>;
        std::vector<std::array<double, Several::count>> numbers;
        std::vector<Several> parameters;
        for (std::size_t first = 0; first < sums.size(); first += Several::count) {
            for (std::size_t lane = 0; lane < Several::count; ++lane) {
                // Lanes past the end repeat the last individual; what they compute is not used.
                const auto& of_one = parameters_of(std::min(first + lane, sums.size() - 1));
                numbers.resize(of_one.size());
                for (std::size_t j = 0; j < of_one.size(); ++j)
                    numbers[j][lane] = of_one[j];
            }
            parameters.assign(numbers.begin(), numbers.end());
            Several sum = 0.0;
            for (const auto& sample : samples)
                sum += term(std::span<const Several>(parameters), sample);
            const auto found = sum.numbers();
            for (std::size_t lane = 0; lane < std::min(Several::count, sums.size() - first); ++lane)
                sums[first + lane] = found[lane];
        }
    });
}

/// A problem whose error is stated as a function of its parameters, for doubles and for Lanes alike, so that several
/// individuals can be evaluated at once: `parameters_of(string)` decodes them, an array or vector of one length,
/// `error_of<T>(parameters, sample)` is the error, with T = double for one individual, with T = Lanes<width> for
/// several.
template <typename P, typename G>
concept ErrorOfParameters = requires(const P& problem, const G& genome, std::span<const Lanes<2>> parameters,
                                     std::span<const double> sample) {
    { problem.parameters_of(genome)[0] } -> std::convertible_to<double>;
    { problem.template error_of<Lanes<2>>(parameters, sample) } -> std::convertible_to<Lanes<2>>;
};

/// The fitness of each of the strings over the samples, the bits of one individual evaluated after the other.
/// `coded(genome)` is the string as the problem shall read it. REQUIRES: fitness.size() == population.size().
template <typename P, typename Genomes, typename Samples, typename Coded>
void fitness_in_lanes(const P& problem, const Genomes& population, const Samples& samples, double bias, Coded coded,
                      std::span<double> fitness) {
    auto parameters_of = [&](std::size_t i) { return problem.parameters_of(coded(population[i])); };
    auto term = [&]<class T>(std::span<const T> parameters, const auto& sample) __attribute__((flatten)) {
        return fitness_term<T>(bias, problem.template error_of<T>(parameters, std::span<const double>(sample)));
    };
    sum_in_lanes(parameters_of, samples, term, fitness);
}

} // namespace placedpar
