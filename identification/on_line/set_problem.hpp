#pragma once

#include "gaprocs/representation/genome.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "identification/circuit_problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar::identification {

/// One LinkSample for each link of a population set, in the order of links_of().
using SetSample = std::vector<hydraulics::LinkSample>;

/// The search for the compliances of a population set while the main valve is in one configuration. The string
/// codes the links in the order of Figure 3.13, each in Gray code, so that a population means the same in every
/// configuration that uses it; the order of the circuit's junctions is hidden here.
class SetProblem {
public:
    /// REQUIRES: `links` is a non-empty part of one coupled group of the configuration.
    SetProblem(hydraulics::Configuration configuration, hydraulics::LinkSet links,
               const hydraulics::FlowConstants& flow, std::size_t bits);

    /// Of the whole string.
    std::size_t bits() const { return bits_ * circuit_.size(); }

    const hydraulics::Circuit& circuit() const { return circuit_; }
    const hydraulics::FlowConstants& flow() const { return flow_; }
    /// The place in the set of the link of each junction.
    const std::vector<std::size_t>& positions() const { return positions_; }
    std::vector<hydraulics::LinkSample> by_junction(const SetSample& sample) const;

    /// Of link number `position` of the set.
    double compliance_in3_per_psi(const Genome& genome, std::size_t position) const;
    double step_in3_per_psi() const;

    /// Does flow enter every cylinder, by the steady flow of the circuit? Otherwise equation 3.6 does not hold.
    bool open(const SetSample& sample) const;

    /// What the window's noise leaves uncertain of each compliance, by least squares from an answer; both in the set's
    /// order. Infinite where the window does not determine it.
    std::vector<double> standard_errors_in3_per_psi(std::span<const SetSample> window,
                                                    std::span<const double> answer_in3_per_psi) const;

    /// What fitness() takes of a window.
    std::vector<hydraulics::CircuitTerms> prepared(std::span<const SetSample> window) const;
    /// The sum of fitness_term over the window, for each string (eq. 3.9).
    std::vector<double> fitness(std::span<const Genome> strings, std::span<const hydraulics::CircuitTerms> window,
                                double bias) const;

private:
    hydraulics::Circuit circuit_;
    hydraulics::FlowConstants flow_;
    std::size_t bits_;
    std::vector<std::size_t> positions_;
};

} // namespace placedpar::identification
