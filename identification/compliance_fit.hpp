#pragma once

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

/// These functions compute compliances with which the genetic algorithm's answer is compared, by least squares and by
/// trying all strings.

/// Compliances found by least squares. The standard errors follow from the scatter of the residuals.
struct ComplianceFit {
    std::vector<double> compliance_in3_per_psi; ///< in the circuit's order; not limited to the search's range
    std::vector<double> standard_error;         ///< infinite if the samples do not determine the compliance
    double rms_in3_per_s;                       ///< rms of the missing flows
};

/// Finds the compliances with the least sum of squares of the missing flows, over all junctions and samples. The
/// missing flow is the error of a junction's flow balance (equations 3.5 to 3.8, flows with their signs). Uses the
/// Gauss-Newton method from `start`, usually the search's answer. Returns nullopt if the fit does not converge within
/// 50 steps. REQUIRES: samples of this circuit, start.size() == circuit.size().
std::optional<ComplianceFit> fit_compliances(const hydraulics::Circuit& circuit,
                                             std::span<const hydraulics::CircuitSample> samples,
                                             const hydraulics::FlowConstants& flow, std::span<const double> start);

/// Fits compliances as fit_compliances() does, but scales the missing flows by FlowWeights (flow_weights.hpp). Weights
/// and compliances are computed alternately. The standard errors are the least that the noise of the samples allows
/// (the Cramer-Rao bound).
std::optional<ComplianceFit> fit_weighed_compliances(const hydraulics::Circuit& circuit,
                                                     std::span<const hydraulics::CircuitSample> samples,
                                                     const hydraulics::FlowConstants& flow,
                                                     std::span<const double> start);

/// The string of greatest fitness over a window, found by evaluating all strings.
struct ExhaustiveOptimum {
    std::vector<std::uint64_t> codes; ///< the code of each junction's compliance
    double fitness;                   ///< sum of bias - error^2 over the window (equation 3.9)
};

/// The greatest length of strings that exhaustive_optimum() accepts, in bits; 2^20 is about a million strings.
inline constexpr std::size_t exhaustive_bits = 20;

/// Evaluates all strings and returns the best. A code stands for the compliance `largest_in3_per_psi` * code /
/// 2^`bits`. REQUIRES: circuit.size() * bits <= exhaustive_bits.
ExhaustiveOptimum exhaustive_optimum(const hydraulics::Circuit& circuit,
                                     std::span<const hydraulics::CircuitSample> window,
                                     const hydraulics::FlowConstants& flow, hydraulics::InletFlow form,
                                     std::size_t bits, double largest_in3_per_psi, double bias);

} // namespace placedpar::identification
