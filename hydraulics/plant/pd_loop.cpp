#include "hydraulics/plant/pd_loop.hpp"

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::hydraulics {

namespace {

/// The coefficients of the denominator of the loop's transfer function, s^3 + square s^2 + linear s + constant.
struct Denominator {
    double square, linear, constant;
};

Denominator denominator(const PdLoop& loop) {
    return {loop.a2_per_s, loop.a1_per_s2 + loop.a0_per_s3 * loop.kv_s, loop.kp * loop.a0_per_s3};
}

/// Returns the matrix that maps theta, theta', theta'' to their derivatives.
Eigen::Matrix3d companion(const PdLoop& loop) {
    Denominator d = denominator(loop);
    Eigen::Matrix3d matrix;
    matrix << 0, 1, 0, 0, 0, 1, -d.constant, -d.linear, -d.square;
    return matrix;
}

} // namespace

PdLoop reference_pd_loop(const Parameters& parameters) {
    double a1 = parameters["pd_loop.hydraulic_frequency"] * parameters["pd_loop.hydraulic_frequency"];
    return {a1 * parameters["pd_loop.speed_gain"], a1, parameters["pd_loop.hydraulic_damping"],
            parameters["pd_loop.proportional_gain"], parameters["pd_loop.velocity_gain"]};
}

PdLoop pd_loop_of(const HydraulicJoint& joint, double kp, double kv_s) {
    double softness = joint.inertia_kg_m2 * joint.compliance_m3_per_pa;
    double displacement = joint.displacement_m3_per_rad;
    return {2 * joint.flow_gain_m2_per_s * displacement / softness, 2 * displacement * displacement / softness,
            joint.flow_pressure_m3_per_s_per_pa / joint.compliance_m3_per_pa, kp, kv_s};
}

PdLoop with_compliance(const PdLoop& loop, double factor) {
    PdLoop other = loop;
    other.a0_per_s3 /= factor;
    other.a1_per_s2 /= factor;
    other.a2_per_s /= factor;
    return other;
}

PdLoop as_printed(const PdLoop& loop) {
    PdLoop printed = loop;
    std::swap(printed.a1_per_s2, printed.a2_per_s);
    return printed;
}

std::array<std::complex<double>, 3> poles(const PdLoop& loop) {
    Eigen::Vector3cd values = companion(loop).eigenvalues();
    std::array<std::complex<double>, 3> sorted{values[0], values[1], values[2]};
    std::ranges::sort(sorted, {}, [](std::complex<double> pole) { return std::pair(pole.real(), pole.imag()); });
    return sorted;
}

std::optional<Oscillation> oscillation(const PdLoop& loop) {
    for (std::complex<double> pole : poles(loop))
        if (pole.imag() > 0)
            return Oscillation{-pole.real() / std::abs(pole), std::abs(pole)};
    return std::nullopt;
}

double stability_margin(const PdLoop& loop) {
    Denominator d = denominator(loop);
    return d.square * d.linear / d.constant;
}

std::vector<double> step_response(const PdLoop& loop, double step_s, std::size_t count) {
    // The deviation from the final value obeys the homogeneous equation.
    Eigen::Matrix3d advance = (companion(loop) * step_s).exp();
    Eigen::Vector3d deviation(-1, 0, 0);
    std::vector<double> response;
    for (; response.size() < count; deviation = advance * deviation)
        response.push_back(1 + deviation[0]);
    return response;
}

StepFigures figures_of(const std::vector<double>& response, double step_s) {
    auto peak = std::ranges::max_element(response);
    auto settled =
        std::find_if(response.rbegin(), response.rend(), [](double value) { return std::abs(value - 1) > 0.02; });
    return {100 * std::max(*peak - 1, 0.0), static_cast<double>(peak - response.begin()) * step_s,
            static_cast<double>(response.rend() - settled) * step_s};
}

} // namespace placedpar::hydraulics
