#pragma once

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace placedpar::identification {

/// Scales the missing flows of a circuit so that they become uncorrelated. Two junctions share the flow through a
/// bypass, so an error in the bypass area appears in two missing flows with opposite signs. The sum of absolute values
/// in equation 3.11 counts this error twice; the weights remove this effect. The weights are our addition: the thesis
/// weighs all flows alike.
struct FlowWeights {
    /// The inverse of the Cholesky factor of the scatter (mean products of the missing flows), times a constant. Row j
    /// has entries for the junctions up to j.
    hydraulics::PerJunction<hydraulics::PerJunction<double>> rows{};

    /// Returns the scaled flows of the first `junctions` junctions. T is double or Lanes.
    template <typename T>
    hydraulics::PerJunction<T> scaled(const hydraulics::PerJunction<T>& missing, std::size_t junctions) const {
        hydraulics::PerJunction<T> scaled;
        for (std::size_t j = 0; j < junctions; ++j) {
            scaled[j] = rows[j][0] * missing[0];
            for (std::size_t k = 1; k <= j; ++k)
                scaled[j] += rows[j][k] * missing[k];
        }
        return scaled;
    }
};

/// Returns the weights for the scatter of the missing flows at these compliances. The mean squares of the scaled flows
/// add up to `mean_square`. REQUIRES: samples of this circuit, at least one; a compliance for each junction.
FlowWeights weights_at(const hydraulics::Circuit& circuit, std::span<const hydraulics::CircuitSample> samples,
                       const hydraulics::FlowConstants& flow, std::span<const double> compliance_in3_per_psi,
                       double mean_square);

/// The mean square of the weighed error at the best individual, as a share of the bias of equation 3.9. Fitness then
/// selects equally well at each level of noise.
inline constexpr double share_of_bias = 0.25;

/// Returns the root of the sum of squares of the scaled flows.
template <typename T>
T weighed_error(const hydraulics::Circuit& circuit, std::span<const T> compliances,
                const hydraulics::CircuitTerms& terms, const hydraulics::FlowConstants& flow,
                const FlowWeights& weights) {
    using std::sqrt;
    auto missing =
        hydraulics::missing_flows_in3_per_s<T>(circuit, compliances, terms, flow, hydraulics::InletFlow::as_signed);
    auto scaled = weights.scaled<T>(missing, circuit.size());
    T squares = scaled[0] * scaled[0];
    for (std::size_t j = 1; j < circuit.size(); ++j)
        squares += scaled[j] * scaled[j];
    return sqrt(squares);
}

/// A CircuitProblem whose error is weighed_error().
class WeighedCircuit : public CircuitProblem {
public:
    WeighedCircuit(const CircuitProblem& problem, const hydraulics::FlowConstants& flow, const FlowWeights& weights)
        : CircuitProblem(problem), flow_(flow), weights_(weights) {}

    template <typename T>
    T error_of(std::span<const T> compliances, const hydraulics::CircuitTerms& terms) const {
        return weighed_error<T>(circuit(), compliances, terms, flow_, weights_);
    }
    template <typename T>
    T error_of(std::span<const T> compliances, std::span<const double> sample) const {
        return error_of(compliances, prepared(sample));
    }
    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        Compliances compliances = parameters_of(genome);
        return error_of<double>(std::span<const double>(compliances.data(), compliances.size()), sample);
    }

private:
    hydraulics::FlowConstants flow_;
    FlowWeights weights_;
};

} // namespace placedpar::identification
