#pragma once

#include "gaprocs/representation/genome.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "identification/circuit_problem.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar::identification {

struct FlowWeights; // identification/flow_weights.hpp

/// One LinkSample for each link of a population set (population_sets.hpp), in the order of links_of().
using SetSample = std::vector<hydraulics::LinkSample>;

/// The search for the compliances of a population set's links, in one configuration of the main valve. The string codes
/// the links' compliances in the order of Figure 3.13, each in Gray code. So the strings of a population have the same
/// meaning in all configurations. The circuit's junctions may have another order, which this class hides.
class SetProblem {
public:
    /// REQUIRES: `links` is not empty, and all its links are in one group that the configuration couples
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
    double step_in3_per_psi() const;

    /// Returns whether oil flows into every cylinder, according to the circuit's steady flow. If not, equation 3.6 does
    /// not hold.
    bool open(const SetSample& sample) const;

    /// Returns the standard error of each compliance from a least-squares fit to the window. The fit starts at the
    /// given answer. Answer and errors are in the order of links_of(). An error is infinite if the window does not
    /// determine the compliance.
    std::vector<double> standard_errors_in3_per_psi(std::span<const SetSample> window,
                                                    std::span<const double> answer_in3_per_psi) const;

    /// Returns the terms of the equations that depend only on the window, for fitness().
    std::vector<hydraulics::CircuitTerms> prepared(std::span<const SetSample> window) const;
    /// Returns, for each string, the sum of fitness_term over the window (eq. 3.9), with weighed_error() if there are
    /// weights.
    std::vector<double> fitness(std::span<const Genome> strings, std::span<const hydraulics::CircuitTerms> window,
                                double bias, const FlowWeights* weights = nullptr) const;

private:
    hydraulics::Circuit circuit_;
    hydraulics::FlowConstants flow_;
    std::size_t bits_;
    std::vector<std::size_t> positions_;
};

} // namespace placedpar::identification
