#include "identification/on_line/set_problem.hpp"

#include "gaprocs/population_fitness.hpp"
#include "gaprocs/representation/coding.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/on_line/population_sets.hpp"

#include <algorithm>

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

std::vector<double> SetProblem::fitness(std::span<const Genome> strings, std::span<const SetSample> window,
                                        double bias) const {
    std::vector<SetSample> ordered;
    for (const SetSample& sample : window)
        ordered.push_back(by_junction(sample));
    auto compliances_of = [&](std::size_t i) {
        CircuitProblem::Compliances compliances;
        for (std::size_t position : positions_)
            compliances.push_back(compliance_in3_per_psi(strings[i], position));
        return compliances;
    };
    auto term = [&]<class T>(std::span<const T> compliances, const SetSample& sample) {
        return fitness_term<T>(bias,
                               circuit_error_in3_per_s<T>(circuit_, compliances, sample, flow_, InletFlow::as_signed));
    };
    std::vector<double> fitness(strings.size());
    sum_in_lanes(compliances_of, ordered, term, fitness);
    return fitness;
}

} // namespace placedpar::identification
