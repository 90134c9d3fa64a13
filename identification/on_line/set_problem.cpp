#include "identification/on_line/set_problem.hpp"

#include "gaprocs/population_fitness.hpp"
#include "gaprocs/representation/coding.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/compliance_fit.hpp"
#include "identification/flow_weights.hpp"
#include "identification/on_line/population_sets.hpp"

#include <algorithm>
#include <limits>

namespace placedpar::identification {

using namespace hydraulics;

SetProblem::SetProblem(Configuration configuration, LinkSet links, const FlowConstants& flow, std::size_t bits)
    : circuit_(circuit_of(configuration, links)), flow_(flow), bits_(bits) {
    for (const Junction& junction : circuit_)
        positions_.push_back(position_in(links, junction.link));
}

double SetProblem::step_in3_per_psi() const {
    return CircuitProblem::largest_in3_per_psi / static_cast<double>(std::uint64_t{1} << bits_);
}

double SetProblem::compliance_in3_per_psi(const Genome& genome, std::size_t position) const {
    return step_in3_per_psi() * static_cast<double>(gray_decoded(genome.field(position * bits_, bits_)));
}

std::vector<LinkSample> SetProblem::by_junction(const SetSample& sample) const {
    std::vector<LinkSample> samples;
    for (std::size_t position : positions_)
        samples.push_back(sample[position]);
    return samples;
}

bool SetProblem::open(const SetSample& sample) const {
    return std::ranges::all_of(sample, [](const LinkSample& link) { return link.inlet_in2 > 0; }) &&
           all_open(circuit_, by_junction(sample), flow_, 0);
}

std::vector<double> SetProblem::standard_errors_in3_per_psi(std::span<const SetSample> window,
                                                            std::span<const double> answer) const {
    std::vector<CircuitSample> samples;
    for (const SetSample& sample : window)
        samples.push_back({samples.size(), 0, by_junction(sample)});
    std::vector<double> start;
    for (std::size_t position : positions_)
        start.push_back(answer[position]);
    const auto fit = fit_compliances(circuit_, samples, flow_, start);
    std::vector<double> errors(positions_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t j = 0; fit && j < positions_.size(); ++j)
        errors[positions_[j]] = fit->standard_error[j];
    return errors;
}

std::vector<CircuitTerms> SetProblem::prepared(std::span<const SetSample> window) const {
    std::vector<CircuitTerms> prepared;
    prepared.reserve(window.size());
    for (const SetSample& sample : window)
        prepared.push_back(terms_of(by_junction(sample), flow_));
    return prepared;
}

std::vector<double> SetProblem::fitness(std::span<const Genome> strings, std::span<const CircuitTerms> window,
                                        double bias, const FlowWeights* weights) const {
    auto decoded = [&]<std::size_t width>(std::size_t first) __attribute__((always_inline)) {
        const StringsInLanes<width, true> several(strings, first);
        CircuitProblem::CompliancesOf<Lanes<width>> compliances;
        for (std::size_t position : positions_)
            compliances.push_back(step_in3_per_psi() * several.field(position * bits_, bits_));
        return compliances;
    };
    auto terms = [&]<class T>(std::span<const T> compliances) {
        return [ this, bias, compliances, weights ](const CircuitTerms& sample) __attribute__((flatten)) {
            return fitness_term<T>(
                bias, weights ? weighed_error<T>(circuit_, compliances, sample, flow_, *weights)
                              : circuit_error_in3_per_s<T>(circuit_, compliances, sample, flow_, InletFlow::as_signed));
        };
    };
    std::vector<double> fitness(strings.size());
    sum_in_lanes_from(decoded, window, terms, fitness);
    return fitness;
}

} // namespace placedpar::identification
