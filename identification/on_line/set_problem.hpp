#pragma once

#include "gaprocs/representation/genome.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "identification/circuit_problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar::identification {

struct FlowWeights; // identification/flow_weights.hpp

/// The measured values of each link of a population set, in the order of links_of() (population_sets.hpp). A population
/// set is a set of links whose compliances one population searches together.
using SetSample = std::vector<hydraulics::LinkSample>;

/// The search for the compliances of a population set's links, in one configuration of the main valve. The string codes
/// the links' compliances in the order of Figure 3.13, each in Gray code. Therefore a population can be used in all
/// configurations, although the circuit's junctions may have another order. This class converts between the two orders.
class SetProblem {
public:
    /// REQUIRES: `links` is not empty, and all its links are in one coupled group: they share oil in this configuration
    /// (hydraulics::coupled_groups()).
    SetProblem(hydraulics::Configuration configuration, hydraulics::LinkSet links,
               const hydraulics::FlowConstants& flow, std::size_t bits);

    /// Returns the length of the whole string.
    std::size_t bits() const { return bits_ * circuit_.size(); }

    const hydraulics::Circuit& circuit() const { return circuit_; }
    const hydraulics::FlowConstants& flow() const { return flow_; }
    /// Returns, for each junction, the position of its link in the set.
    const std::vector<std::size_t>& positions() const { return positions_; }
    std::vector<hydraulics::LinkSample> by_junction(const SetSample& sample) const;

    /// Returns the compliance of the link at `position` in the set.
    double compliance_in3_per_psi(const Genome& genome, std::size_t position) const;
    /// Returns the difference between the compliances of neighbouring codes.
    double step_in3_per_psi() const;

    /// Returns whether oil flows into every cylinder, according to the circuit's steady flow. Only then does equation
    /// 3.6 hold, which gives the pressures at the junctions.
    bool open(const SetSample& sample) const;

    /// Returns the standard error of each compliance from a least-squares fit to the window. The fit starts at the
    /// compliances `answer_in3_per_psi`. Answer and errors are in the order of links_of(). If the window does not
    /// determine a compliance, its error is infinite.
    std::vector<double> standard_errors_in3_per_psi(std::span<const SetSample> window,
                                                    std::span<const double> answer_in3_per_psi) const;

    /// Returns the terms of the equations that depend only on the window of samples. A search computes them once for
    /// all strings.
    std::vector<hydraulics::CircuitTerms> prepared(std::span<const SetSample> window) const;
    /// Returns the fitness of each string over the window (equation 3.9). With `weights`, the error in the fitness is
    /// weighed_error() (flow_weights.hpp).
    std::vector<double> fitness(std::span<const Genome> strings, std::span<const hydraulics::CircuitTerms> window,
                                double bias, const FlowWeights* weights = nullptr) const;

private:
    hydraulics::Circuit circuit_;
    hydraulics::FlowConstants flow_;
    std::size_t bits_;
    std::vector<std::size_t> positions_;
};

} // namespace placedpar::identification
