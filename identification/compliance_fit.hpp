#pragma once

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

/// These functions compute compliances by least squares, and by trying all strings. The genetic algorithm's answer is
/// compared with them.

/// Compliances found by least squares. The standard errors follow from the scatter of the residuals.
struct ComplianceFit {
    std::vector<double> compliance_in3_per_psi; ///< in the circuit's order; not limited to the search's range
    std::vector<double> standard_error;         ///< infinite if the samples do not determine the compliance
    double rms_in3_per_s;                       ///< root mean square of the missing flows of all junctions and samples
};

/// Finds the compliances with the least sum of squares of the missing flows. The missing flow is the error of a
/// junction's flow balance at one sample (equations 3.5 to 3.8, with the sign of the flow into the cylinder). Uses the
/// Gauss-Newton method, which begins at `start`, usually the genetic algorithm's answer. Returns nullopt if the fit
/// does not converge within 50 steps. REQUIRES: samples of this circuit, start.size() == circuit.size().
std::optional<ComplianceFit> fit_compliances(const hydraulics::Circuit& circuit,
                                             std::span<const hydraulics::CircuitSample> samples,
                                             const hydraulics::FlowConstants& flow, std::span<const double> start);

/// Fits compliances as fit_compliances() does, but first makes the missing flows of the junctions uncorrelated
/// (flow_weights.hpp). Computes weights and compliances alternately. The standard errors are the least that the noise
/// of the samples allows (the Cramer-Rao bound).
std::optional<ComplianceFit> fit_weighed_compliances(const hydraulics::Circuit& circuit,
                                                     std::span<const hydraulics::CircuitSample> samples,
                                                     const hydraulics::FlowConstants& flow,
                                                     std::span<const double> start);

/// The best string for a window of samples, found by evaluating all strings.
struct ExhaustiveOptimum {
    std::vector<std::uint64_t> codes; ///< the code of each junction's compliance
    double fitness;                   ///< sum of bias - error^2 over the window (equation 3.9)
};

/// The greatest length of strings, in bits, of which exhaustive_optimum() evaluates all: about a million strings.
inline constexpr std::size_t exhaustive_bits = 20;

/// Evaluates all strings and returns the string of greatest fitness. A code stands for the compliance
/// `largest_in3_per_psi` * code / 2^`bits`. REQUIRES: circuit.size() * bits <= exhaustive_bits.
ExhaustiveOptimum exhaustive_optimum(const hydraulics::Circuit& circuit,
                                     std::span<const hydraulics::CircuitSample> window,
                                     const hydraulics::FlowConstants& flow, hydraulics::InletFlow form,
                                     std::size_t bits, double largest_in3_per_psi, double bias);

} // namespace placedpar::identification
