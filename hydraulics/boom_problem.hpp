#pragma once

#include "hydraulics/flow_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// What the error of the single-link identification needs of one sampling instant.
struct BoomSample {
    double inlet_psi;             // P_i, the raw reading
    double inlet_slope_psi_per_s; // of the 5-point line
    double piston_flow_in3_per_s; // A_i times the piston velocity, of the 5-point line
    double inlet_in2;             // a_i, from the spool
    double bypass_in2;            // a_e

    static constexpr std::size_t channels = 5;
    std::vector<double> values() const;
    /// REQUIRES: values.size() == channels.
    static BoomSample from(std::span<const double> values) {
        return {values[0], values[1], values[2], values[3], values[4]};
    }
};

/// A binary string that can be read as natural binary numbers.
template <typename G>
concept BinaryString = requires(const G& genome) {
    { genome.field(std::size_t{}, std::size_t{}) } -> std::convertible_to<std::uint64_t>;
};

/// The error of equations 3.5 to 3.8 in in^3/s, by which the pump's flow is missed: the pump pressure is too
/// noisy to be used, so that it is estimated from the flow into the cylinder.
/// REQUIRES: sample.inlet_in2 > 0.
inline double boom_error_in3_per_s(double compliance_in3_per_psi, const BoomSample& sample, const FlowConstants& flow) {
    double k = flow.orifice_in3_per_s_in2_sqrt_psi;
    double inlet = sample.piston_flow_in3_per_s + sample.inlet_slope_psi_per_s * compliance_in3_per_psi; // 3.5
    double root = inlet / (k * sample.inlet_in2);
    double pump_psi = root * root + sample.inlet_psi;                                           // 3.6
    double bypass = k * sample.bypass_in2 * std::sqrt(std::max(pump_psi - flow.tank_psi, 0.0)); // 3.7
    return std::abs(flow.pump_in3_per_s - std::abs(inlet) - std::abs(bypass));                  // 3.8
}

/// Identification of the boom's pump-side compliance from one link's motion (thesis 3.1), as a search
/// problem: the compliance is a natural binary number n of `bits` bits, C = largest * n / 2^bits (eq. 1.5).
class BoomProblem {
public:
    /// Ours: the thesis does not print the length; 10 bits resolve 1.1 % of its .0086.
    static constexpr std::size_t string_bits = 10;
    /// Thesis 3.1.1: 0.1 > C_i > 0.0.
    static constexpr double largest_in3_per_psi = 0.1;

    explicit BoomProblem(FlowConstants flow, std::optional<double> true_compliance_in3_per_psi = {})
        : flow_(flow), true_compliance_(true_compliance_in3_per_psi) {}

    std::size_t bits() const { return string_bits; }
    std::size_t channels() const { return BoomSample::channels; }

    static double compliance_in3_per_psi(std::uint64_t code) {
        return largest_in3_per_psi * static_cast<double>(code) / (1u << string_bits);
    }

    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        double compliance = compliance_in3_per_psi(genome.field(0, string_bits));
        return boom_error_in3_per_s(compliance, BoomSample::from(sample), flow_);
    }
    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        return {compliance_in3_per_psi(genome.field(0, string_bits))};
    }

    std::vector<std::string> parameter_names() const;
    std::vector<std::string> parameter_units() const;
    /// Empty where the record is measured, not simulated.
    std::vector<double> true_parameters() const;

private:
    FlowConstants flow_;
    std::optional<double> true_compliance_;
};

} // namespace placedpar
