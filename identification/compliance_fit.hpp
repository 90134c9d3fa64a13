#pragma once

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

/// References for the genetic algorithm's answer. They use the equations of the circuit; it sees only fitness.

/// Compliances by least squares, and how uncertain the scatter of the residuals leaves them.
struct ComplianceFit {
    std::vector<double> compliance_in3_per_psi; ///< in the circuit's order; not limited to the search's range
    std::vector<double> standard_error;         ///< infinite where the samples do not determine it
    double rms_in3_per_s;                       ///< of the missing flows
};

/// Least squares on the signed missing flows of all junctions and samples (equations 3.5 to 3.8), by Gauss-Newton from
/// a start, usually the search's answer. None when it does not settle within 50 steps. REQUIRES: samples of this
/// circuit, start.size() == circuit.size().
std::optional<ComplianceFit> fit_compliances(const hydraulics::Circuit& circuit,
                                             std::span<const hydraulics::CircuitSample> samples,
                                             const hydraulics::FlowConstants& flow, std::span<const double> start);

/// The string of greatest fitness over a window, found by trying all.
struct ExhaustiveOptimum {
    std::vector<std::uint64_t> codes; ///< one for each junction
    double fitness;                   ///< sum of bias - error^2 (equation 3.9)
};

/// The longest string for which all values are tried: a million.
inline constexpr std::size_t exhaustive_bits = 20;

/// C = largest * code / 2^bits. REQUIRES: circuit.size() * bits <= exhaustive_bits.
ExhaustiveOptimum exhaustive_optimum(const hydraulics::Circuit& circuit,
                                     std::span<const hydraulics::CircuitSample> window,
                                     const hydraulics::FlowConstants& flow, hydraulics::InletFlow form,
                                     std::size_t bits, double largest_in3_per_psi, double bias);

} // namespace placedpar::identification
