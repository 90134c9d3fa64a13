#pragma once

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace placedpar {

/// References that the genetic algorithm's answer is held against. They know the equations; it does not.

/// Compliances of least squares, with what the scatter of the residuals leaves open.
struct ComplianceFit {
    std::vector<double> compliance_in3_per_psi; // in the circuit's order; not limited to the search's range
    std::vector<double> standard_error;         // infinite where the samples say nothing of a compliance
    double rms_in3_per_s;                       // of what is missing at the junctions
};

/// Least squares on the signed missing flows of all junctions and samples, by Gauss-Newton from a start (mostly
/// the search's answer). None when it does not settle within 50 steps.
/// REQUIRES: samples of this circuit, start.size() == circuit.size().
std::optional<ComplianceFit> fit_compliances(const hydraulics::Circuit& circuit,
                                             std::span<const hydraulics::CircuitSample> samples,
                                             const hydraulics::FlowConstants& flow, std::span<const double> start);

/// The codes of the strings of greatest fitness over a window: all of them are tried.
struct ExhaustiveOptimum {
    std::vector<std::uint64_t> codes; // one for each junction
    double fitness;                   // sum of bias - error^2 (equation 3.9)
};

/// Longest string that is tried in all its values: a million of them.
inline constexpr std::size_t exhaustive_bits = 20;

/// C = largest * code / 2^bits. REQUIRES: circuit.size() * bits <= exhaustive_bits.
ExhaustiveOptimum exhaustive_optimum(const hydraulics::Circuit& circuit,
                                     std::span<const hydraulics::CircuitSample> window,
                                     const hydraulics::FlowConstants& flow, hydraulics::InletFlow form,
                                     std::size_t bits, double largest_in3_per_psi, double bias);

} // namespace placedpar
