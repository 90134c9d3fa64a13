#pragma once

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace placedpar::identification {

/// Combines the missing flows of a circuit, that is, the errors of its junctions' flow balances, so that they become
/// uncorrelated. Two junctions share the flow through a bypass. An error in the bypass's area therefore appears in two
/// missing flows, with opposite signs. The sum of absolute values in equation 3.11 counts this error twice; the
/// weighted error counts it once. The thesis gives all flows the same weight.
struct FlowWeights {
    /// The inverse of the Cholesky factor of the missing flows' scatter matrix (the mean products of each two flows),
    /// times a constant. Row j has entries for the junctions up to j.
    hydraulics::PerJunction<hydraulics::PerJunction<double>> rows{};

    /// Returns the uncorrelated flows of the first `junctions` junctions. T is double, or Lanes, a class of several
    /// doubles.
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

/// Returns the weights that make the missing flows at these compliances uncorrelated. With these weights, the mean
/// squares of the scaled flows add up to `mean_square`. REQUIRES: samples of this circuit, at least one; a compliance
/// for each junction.
FlowWeights weights_at(const hydraulics::Circuit& circuit, std::span<const hydraulics::CircuitSample> samples,
                       const hydraulics::FlowConstants& flow, std::span<const double> compliance_in3_per_psi,
                       double mean_square);

/// `mean_square` of weights_at(), as a share of the bias in the fitness (equation 3.9). If the best individual always
/// has this share of error, selection by fitness works equally well at each level of noise.
inline constexpr double share_of_bias = 0.25;

/// Returns the error of these compliances at one sample: the root of the sum of squares of the scaled flows.
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

/// A CircuitProblem (the search for a circuit's compliances) with weighed_error() as its error.
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
