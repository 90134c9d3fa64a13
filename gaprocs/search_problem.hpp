#pragma once

#include "gaprocs/fitness.hpp"
#include "gaprocs/genome.hpp"

#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// The numbers measured at one sampling instant, in the order the problem states.
using Sample = std::vector<double>;

/// What a search needs to know of a problem. A plain struct satisfies it without including this header: it
/// may take the genome as a template parameter and read it by field(first, count). Optional:
/// `true_parameters()`, the values a simulated record was made with.
template <typename P>
concept Searchable = requires(const P& problem, const Genome& genome, std::span<const double> sample) {
    { problem.bits() } -> std::convertible_to<std::size_t>;
    { problem.channels() } -> std::convertible_to<std::size_t>;
    { problem.error(genome, sample) } -> std::convertible_to<double>;
    { problem.decode(genome) } -> std::convertible_to<std::vector<double>>;
    { problem.parameter_names() } -> std::convertible_to<std::vector<std::string>>;
    { problem.parameter_units() } -> std::convertible_to<std::vector<std::string>>;
};

/// A search problem whose type has been forgotten, so that processes can find it by name. Immutable: any
/// number of processes may read one.
class SearchProblem {
public:
    virtual ~SearchProblem() = default;

    /// Length of the binary string.
    virtual std::size_t bits() const = 0;
    /// Numbers in a sample.
    virtual std::size_t channels() const = 0;
    /// The error of one individual at one sample (eq. 3.8). REQUIRES: sizes as stated by bits(), channels().
    virtual double error(const Genome& genome, std::span<const double> sample) const = 0;
    /// The sum of fitness_term over the samples: one call an individual, the loop inside is not virtual.
    virtual double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const = 0;
    /// The parameters coded by the string, with their names and units.
    virtual std::vector<double> decode(const Genome& genome) const = 0;
    virtual std::vector<std::string> parameter_names() const = 0;
    virtual std::vector<std::string> parameter_units() const = 0;
    /// Empty where nobody knows them.
    virtual std::vector<double> true_parameters() const { return {}; }
};

/// SearchProblem around a plain struct.
template <Searchable P>
class SearchProblemOf final : public SearchProblem {
public:
    explicit SearchProblemOf(P problem) : problem_(std::move(problem)) {}

    std::size_t bits() const override { return problem_.bits(); }
    std::size_t channels() const override { return problem_.channels(); }
    double error(const Genome& genome, std::span<const double> sample) const override {
        return problem_.error(genome, sample);
    }
    double fitness(const Genome& genome, std::span<const Sample> samples, double bias) const override {
        double sum = 0;
        for (const Sample& sample : samples)
            sum += fitness_term(bias, problem_.error(genome, std::span<const double>(sample)));
        return sum;
    }
    std::vector<double> decode(const Genome& genome) const override { return problem_.decode(genome); }
    std::vector<std::string> parameter_names() const override { return problem_.parameter_names(); }
    std::vector<std::string> parameter_units() const override { return problem_.parameter_units(); }
    std::vector<double> true_parameters() const override {
        if constexpr (requires {
                          { problem_.true_parameters() } -> std::convertible_to<std::vector<double>>;
                      })
            return problem_.true_parameters();
        else
            return {};
    }

private:
    P problem_;
};

template <Searchable P>
std::shared_ptr<const SearchProblem> make_search_problem(P problem) {
    return std::make_shared<SearchProblemOf<P>>(std::move(problem));
}

} // namespace placedpar
