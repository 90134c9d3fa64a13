#include "identification/on_line/set_problem.hpp"

#include "gaprocs/coding.hpp"
#include "gaprocs/population_fitness.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/on_line/population_sets.hpp"

#include <algorithm>
#include <array>

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
    constexpr std::size_t width = Lanes::SizeAtCompileTime;
    std::vector<SetSample> ordered;
    for (const SetSample& sample : window)
        ordered.push_back(by_junction(sample));
    std::vector<double> fitness(strings.size());
    PerJunction<Lanes> compliance;
    for (std::size_t first = 0; first < strings.size(); first += width) {
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            for (std::size_t i = 0; i < width; ++i) // what lanes past the end compute is not used
                compliance[j][static_cast<Eigen::Index>(i)] =
                    compliance_in3_per_psi(strings[std::min(first + i, strings.size() - 1)], positions_[j]);
        Lanes sum = Lanes::Zero();
        for (const SetSample& sample : ordered)
            sum += fitness_terms(
                bias, circuit_error_in3_per_s<Lanes>(circuit_, compliance, sample, flow_, InletFlow::as_signed));
        std::copy_n(sum.data(), std::min(width, strings.size() - first),
                    fitness.begin() + static_cast<std::ptrdiff_t>(first));
    }
    return fitness;
}

} // namespace placedpar::identification
