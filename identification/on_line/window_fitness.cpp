#include "identification/on_line/window_fitness.hpp"

namespace placedpar::identification {

namespace {

std::uint64_t number_of(const Genome& string) { return string.field(0, string.size()); }

} // namespace

WindowFitness::WindowFitness(const SetProblem& problem, std::span<const SetSample> window, double bias)
    : problem_(problem), window_(problem.prepared(window)), bias_(bias),
      met_(problem.bits() <= most_bits ? std::size_t{1} << problem.bits() : 0), known_(met_.size()) {}

std::vector<double> WindowFitness::operator()(std::span<const Genome> strings) {
    if (met_.empty())
        return problem_.fitness(strings, window_, bias_);
    evaluate(fresh_of(strings));
    std::vector<double> fitness(strings.size());
    for (std::size_t i = 0; i < strings.size(); ++i)
        fitness[i] = known_[number_of(strings[i])];
    return fitness;
}

/// Returns the strings that this object has not met before, each only once.
std::vector<Genome> WindowFitness::fresh_of(std::span<const Genome> strings) {
    std::vector<std::size_t> fresh(strings.size());
    std::size_t found = 0;
    for (std::size_t i = 0; i < strings.size(); ++i) { // without branches, which the processor could not predict
        std::uint8_t& met = met_[number_of(strings[i])];
        fresh[found] = i;
        found += 1u - met;
        met = 1;
    }
    std::vector<Genome> those;
    those.reserve(found);
    for (std::size_t i : std::span(fresh).first(found))
        those.push_back(strings[i]);
    return those;
}

void WindowFitness::evaluate(std::span<const Genome> strings) {
    const std::vector<double> fitness = problem_.fitness(strings, window_, bias_);
    for (std::size_t i = 0; i < strings.size(); ++i)
        known_[number_of(strings[i])] = fitness[i];
}

} // namespace placedpar::identification
