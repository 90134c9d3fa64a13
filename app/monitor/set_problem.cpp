#include "app/monitor/set_problem.hpp"

#include "app/monitor/population_sets.hpp"
#include "gaprocs/fitness.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace placedpar {

namespace {

/// Individuals whose errors are found together: of fixed size, so that nothing is allocated.
constexpr std::size_t block = 8;
using Block = Eigen::Array<double, block, 1>;

std::uint64_t from_gray(std::uint64_t code) {
    for (unsigned shift = 1; shift < 64; shift *= 2)
        code ^= code >> shift;
    return code;
}

} // namespace

SetProblem::SetProblem(Configuration configuration, LinkSet links, const FlowConstants& flow, std::size_t bits)
    : circuit_(circuit_of(configuration, links)), flow_(flow), bits_(bits) {
    std::vector<Link> order = links_of(links);
    for (const Junction& junction : circuit_)
        positions_.push_back(static_cast<std::size_t>(std::ranges::find(order, junction.link) - order.begin()));
}

double SetProblem::step_in3_per_psi() const {
    return CircuitProblem::largest_in3_per_psi / static_cast<double>(std::uint64_t{1} << bits_);
}

double SetProblem::compliance_in3_per_psi(const Genome& genome, std::size_t position) const {
    return step_in3_per_psi() * static_cast<double>(from_gray(genome.field(position * bits_, bits_)));
}

bool SetProblem::open(const SetSample& sample) const {
    // Flow comes down the circuit, pressure is known at its lower end.
    std::array<double, all_links.size()> flow_in3_per_s{}, psi{};
    for (std::size_t j = 0; j < circuit_.size(); ++j) {
        flow_in3_per_s[j] += circuit_[j].pumps * flow_.pump_in3_per_s;
        if (circuit_[j].through == Through::junction)
            flow_in3_per_s[circuit_[j].next] += flow_in3_per_s[j];
    }
    for (std::size_t j = circuit_.size(); j-- > 0;) {
        const LinkSample& link = sample[positions_[j]];
        double conductance = flow_.orifice_in3_per_s_in2_sqrt_psi * link.bypass_in2;
        double below = circuit_[j].through == Through::junction ? psi[circuit_[j].next] : flow_.tank_psi;
        if (circuit_[j].through == Through::nowhere || conductance <= 0)
            psi[j] = std::numeric_limits<double>::infinity();
        else
            psi[j] = below + std::pow(flow_in3_per_s[j] / conductance, 2);
        if (link.inlet_in2 <= 0 || psi[j] <= link.inlet_psi)
            return false;
    }
    return true;
}

std::vector<double> SetProblem::fitness(std::span<const Genome> strings, std::span<const SetSample> window,
                                        double bias) const {
    std::vector<double> sums(strings.size(), 0.0);
    std::array<Block, all_links.size()> compliance;
    std::array<LinkSample, all_links.size()> samples{};
    for (std::size_t first = 0; first < strings.size(); first += block) {
        std::size_t count = std::min(block, strings.size() - first);
        for (std::size_t j = 0; j < circuit_.size(); ++j)
            for (std::size_t i = 0; i < block; ++i) // the last block is filled up with its last individual
                compliance[j][static_cast<Eigen::Index>(i)] =
                    compliance_in3_per_psi(strings[first + std::min(i, count - 1)], positions_[j]);
        for (const SetSample& sample : window) {
            for (std::size_t j = 0; j < circuit_.size(); ++j)
                samples[j] = sample[positions_[j]];
            Block error = circuit_error_in3_per_s<Block>(circuit_, compliance, samples, flow_, InletFlow::as_signed);
            for (std::size_t i = 0; i < count; ++i)
                sums[first + i] += fitness_term(bias, error[static_cast<Eigen::Index>(i)]);
        }
    }
    return sums;
}

} // namespace placedpar
