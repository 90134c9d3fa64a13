#pragma once

#include "hydraulics/flow_constants.hpp"
#include "hydraulics/link_sample.hpp"
#include "hydraulics/parameter_coding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// What the error of the single-link identification needs of one sampling instant.
using BoomSample = LinkSample;

namespace boom_error_detail {

inline double at_least_zero(double x) { return std::max(x, 0.0); }
template <typename Array>
auto at_least_zero(const Array& x) {
    return x.max(0.0);
}

} // namespace boom_error_detail

/// The error of equations 3.5 to 3.8 in in^3/s, by which the pump's flow is missed: the pump pressure is too
/// noisy to be used, so that it is estimated from the flow into the cylinder.
///
/// T is double, or an Eigen array of doubles: one entry for each individual of a population, with the same bits as if
/// each were done alone. REQUIRES: sample.inlet_in2 > 0.
template <typename T>
T boom_error_in3_per_s(const T& compliance_in3_per_psi, const BoomSample& sample, const FlowConstants& flow) {
    using boom_error_detail::at_least_zero;
    using std::abs, std::sqrt;
    const double k = flow.orifice_in3_per_s_in2_sqrt_psi;
    T inlet = sample.piston_flow_in3_per_s + sample.inlet_slope_psi_per_s * compliance_in3_per_psi; // 3.5
    T root = inlet / (k * sample.inlet_in2);
    T pump_psi = root * root + sample.inlet_psi;                                         // 3.6
    T bypass = k * sample.bypass_in2 * sqrt(at_least_zero(T(pump_psi - flow.tank_psi))); // 3.7
    return abs(flow.pump_in3_per_s - abs(inlet) - abs(bypass));                          // 3.8
}

/// Identification of the boom's pump-side compliance from one link's motion (thesis 3.1), as a search
/// problem: the compliance is a whole number of `bits` bits over 0 ... 0.1.
class BoomProblem {
public:
    /// Ours: the thesis does not print the length; 10 bits resolve 1.1 % of its .0086.
    static constexpr std::size_t usual_bits = 10;
    /// Thesis 3.1.1: 0.1 > C_i > 0.0.
    static constexpr double largest_in3_per_psi = 0.1;

    /// Throws std::invalid_argument as ParameterCoding.
    explicit BoomProblem(FlowConstants flow, std::optional<double> true_compliance_in3_per_psi = {},
                         std::size_t bits = usual_bits)
        : flow_(flow), coding_(1, {0, largest_in3_per_psi, bits}), true_compliance_(true_compliance_in3_per_psi) {}

    std::size_t bits() const { return coding_.bits(); }
    std::size_t channels() const { return BoomSample::channels; }

    std::size_t parameters() const { return coding_.parameters(); }
    template <BinaryString G>
    double parameter(const G& genome, std::size_t number) const {
        return coding_.value(genome, number);
    }
    /// The error of one compliance, or of each of an array of them.
    template <typename T>
    T error_of(std::span<const T> compliance, std::span<const double> sample) const {
        return boom_error_in3_per_s(compliance[0], BoomSample::from(sample), flow_);
    }

    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        return boom_error_in3_per_s(coding_.value(genome, 0), BoomSample::from(sample), flow_);
    }
    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        return coding_.decode(genome);
    }

    std::vector<std::string> parameter_names() const;
    std::vector<std::string> parameter_units() const;
    /// Empty where the record is measured, not simulated.
    std::vector<double> true_parameters() const;

private:
    FlowConstants flow_;
    ParameterCoding coding_;
    std::optional<double> true_compliance_;
};

} // namespace placedpar
