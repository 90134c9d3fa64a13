#pragma once

#include "gaprocs/fitness.hpp"
#include "gaprocs/representation/coding.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/strings_in_lanes.hpp"
#include "runtime/lanes.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace placedpar {

/// Sets sums[i] to the sum of individual i's terms over the samples. For speed, computes several individuals at once,
/// each in one lane of a vector register (type Lanes). `parameters_from.operator()<width>(i)` returns the parameters of
/// individual i and the following individuals, as a container of Lanes. `terms(parameters)` takes these parameters as a
/// std::span of Lanes, and returns a function. This function is called with one sample after another, and returns the
/// terms of the sample. The sums are the same, bit for bit, as in a loop over single individuals, because operations on
/// Lanes and on double round alike (runtime/vector_width.hpp).
template <typename ParametersFrom, typename Samples, typename Terms>
void sum_in_lanes_from(const ParametersFrom& parameters_from, const Samples& samples, const Terms& terms,
                       std::span<double> sums) {
    in_vectors([&]<std::size_t width>() __attribute__((flatten)) {
        using Several = Lanes<width>;
        for (std::size_t first = 0; first < sums.size(); first += Several::count) {
            const auto parameters = parameters_from.template operator()<width>(first);
            auto term = terms(std::span<const Several>(parameters.data(), parameters.size()));
            Several sum = 0.0;
            for (const auto& sample : samples)
                sum += term(sample);
            const auto found = sum.numbers();
            if (sums.size() - first >= Several::count) // copying a length known to the compiler is faster
                std::memcpy(&sums[first], found.data(), sizeof found);
            else
                std::copy_n(found.begin(), sums.size() - first, &sums[first]);
        }
    });
}

/// Does the same as sum_in_lanes_from(), but takes the parameters of one individual at a time, from parameters_of(i).
/// REQUIRES: all individuals have the same number of parameters.
template <typename ParametersOf, typename Samples, typename Terms>
void sum_terms_in_lanes(const ParametersOf& parameters_of, const Samples& samples, const Terms& terms,
                        std::span<double> sums) {
    auto side_by_side = [&]<std::size_t width>(std::size_t first) __attribute__((always_inline)) {
        constexpr std::size_t count = Lanes<width>::count;
        std::vector<std::array<double, count>> numbers;
        for (std::size_t lane = 0; lane < count; ++lane) {
            // If too few individuals are left, the other lanes repeat the last; their results are not used.
            const auto& of_one = parameters_of(std::min(first + lane, sums.size() - 1));
            numbers.resize(of_one.size());
            for (std::size_t j = 0; j < of_one.size(); ++j)
                numbers[j][lane] = of_one[j];
        }
        return std::vector<Lanes<width>>(numbers.begin(), numbers.end());
    };
    sum_in_lanes_from(side_by_side, samples, terms, sums);
}

/// Does the same as sum_terms_in_lanes(), for terms that do not depend on earlier samples: `term(parameters, sample)`
/// returns a term.
template <typename ParametersOf, typename Samples, typename Term>
void sum_in_lanes(const ParametersOf& parameters_of, const Samples& samples, const Term& term, std::span<double> sums) {
    auto terms = [&]<class T>(std::span<const T> parameters) {
        return [&term, parameters ](const auto& sample) __attribute__((flatten)) { return term(parameters, sample); };
    };
    sum_terms_in_lanes(parameters_of, samples, terms, sums);
}

/// A problem whose error is a function of decoded parameters. Several individuals of such a problem can be evaluated at
/// once. `parameters_of(string)` decodes the parameters into an array or a vector, whose length is the same for all
/// strings. `error_of<T>(parameters, sample)` returns the error. T is double for one individual, and Lanes<width> for
/// several.
template <typename P, typename G>
concept ErrorOfParameters = requires(const P& problem, const G& genome, std::span<const Lanes<2>> parameters,
                                     std::span<const double> sample) {
    { problem.parameters_of(genome)[0] } -> std::convertible_to<double>;
    { problem.template error_of<Lanes<2>>(parameters, sample) } -> std::convertible_to<Lanes<2>>;
};

/// A problem whose error at a sample depends on the earlier samples of the window, as in a simulation.
/// `errors_along<T>(parameters)` returns a function that is called with one sample of a window after another, oldest
/// first, and returns the error at the sample. The problem also has `parameters_of` and `error_of` of
/// ErrorOfParameters; `error_of` returns the error at the first sample of a window.
template <typename P>
concept ErrorAlongWindow = requires(const P& problem, std::span<const double> parameters,
                                    std::span<const double> sample) {
    { problem.template errors_along<double>(parameters)(sample) } -> std::convertible_to<double>;
};

/// Returns a function for problems of both kinds. It is called with one sample of a window after another, oldest first,
/// and returns the error at the sample.
template <typename T, typename P>
[[gnu::always_inline]] inline auto errors_along(const P& problem, std::span<const T> parameters) {
    if constexpr (ErrorAlongWindow<P>)
        return problem.template errors_along<T>(parameters);
    else
        return [&problem, parameters ](const auto& sample) __attribute__((flatten)) {
            return problem.template error_of<T>(parameters, sample);
        };
}

/// A problem that can decode several strings at once: `parameters_of_several(strings)` takes StringsInLanes (strings
/// side by side in vector registers) and returns the parameters as Lanes.
template <typename P, bool gray>
concept ParametersOfSeveral = requires(const P& problem, const StringsInLanes<2, gray>& strings) {
    { problem.parameters_of_several(strings)[0] } -> std::convertible_to<Lanes<2>>;
};

/// A problem that does the calculations common to all individuals only once for each sample: prepared(sample) returns
/// their result. `error_of<T>(parameters, prepared(sample))` returns the error at the sample.
template <typename P>
concept PreparesSamples = requires(const P& problem, std::span<const Lanes<2>> parameters,
                                   std::span<const double> sample) {
    { problem.template error_of<Lanes<2>>(parameters, problem.prepared(sample)) } -> std::convertible_to<Lanes<2>>;
};

/// Computes the fitness of each string over `samples`. For a problem that PreparesSamples, these are the results of
/// prepared().
template <bool gray, typename P, typename Samples>
void fitness_over(const P& problem, std::span<const Genome> population, const Samples& samples, double bias,
                  std::span<double> fitness) {
    auto terms = [&]<class T>(std::span<const T> parameters) {
        return [bias, error = errors_along<T>(problem, parameters)](const auto& sample) mutable {
            return fitness_term<T>(bias, error(sample));
        };
    };
    if constexpr (ParametersOfSeveral<P, gray>)
        if (problem.bits() <= 64 * StringsInLanes<2>::most_words) {
            auto decoded = [&]<std::size_t width>(std::size_t first) __attribute__((always_inline)) {
                return problem.parameters_of_several(StringsInLanes<width, gray>(population, first));
            };
            return sum_in_lanes_from(decoded, samples, terms, fitness);
        }
    sum_terms_in_lanes([&](std::size_t i) { return problem.parameters_of(StringRead<gray>(population[i])); }, samples,
                       terms, fitness);
}

/// Computes the fitness of each string over the samples. The results are the same, bit for bit, as from evaluating one
/// individual at a time. REQUIRES: every string has problem.bits() bits; fitness.size() == population.size().
template <bool gray, typename P, typename Samples>
void fitness_in_lanes(const P& problem, std::span<const Genome> population, const Samples& samples, double bias,
                      std::span<double> fitness) {
    if constexpr (PreparesSamples<P>) {
        std::vector<decltype(problem.prepared(*samples.begin()))> prepared;
        prepared.reserve(samples.size());
        for (const auto& sample : samples)
            prepared.push_back(problem.prepared(sample));
        fitness_over<gray>(problem, population, prepared, bias, fitness);
    } else
        fitness_over<gray>(problem, population, samples, bias, fitness);
}

} // namespace placedpar
