#include "identification/flow_weights.hpp"

namespace placedpar::identification {

using namespace hydraulics;

namespace {

using Square = PerJunction<PerJunction<double>>;

/// The square of this number is added to the mean square of each missing flow (the error of a junction's flow balance).
/// The number is about the resolution of the readings. Without this addition, some combinations of flows would get
/// unlimited weight in records without noise.
constexpr double least_scatter_in3_per_s = 0.1;
/// With few samples, the mean square of some combination of flows is too small by chance. Therefore shrinkage * mean *
/// junctions / samples^2 is added to the mean square of each flow. `mean` is the mean of the mean squares of all flows.
constexpr double shrinkage = 10;

Square covariance_at(const Circuit& circuit, std::span<const CircuitSample> samples, const FlowConstants& flow,
                     std::span<const double> compliance) {
    Square sum{};
    for (const CircuitSample& sample : samples) {
        auto missing = missing_flows_in3_per_s<double>(circuit, compliance, sample.links, flow, InletFlow::as_signed);
        for (std::size_t j = 0; j < circuit.size(); ++j)
            for (std::size_t k = 0; k <= j; ++k)
                sum[j][k] += missing[j] * missing[k] / static_cast<double>(samples.size());
    }
    double mean = 0;
    for (std::size_t j = 0; j < circuit.size(); ++j)
        mean += sum[j][j] / static_cast<double>(circuit.size());
    const auto count = static_cast<double>(samples.size());
    const double added = least_scatter_in3_per_s * least_scatter_in3_per_s +
                         shrinkage * mean * static_cast<double>(circuit.size()) / (count * count);
    for (std::size_t j = 0; j < circuit.size(); ++j)
        sum[j][j] += added;
    return sum;
}

/// Replaces the lower triangle of a positive definite matrix by its Cholesky factor.
void factorise(Square& matrix, std::size_t size) {
    for (std::size_t j = 0; j < size; ++j)
        for (std::size_t k = 0; k <= j; ++k) {
            double left = matrix[j][k];
            for (std::size_t i = 0; i < k; ++i)
                left -= matrix[j][i] * matrix[k][i];
            matrix[j][k] = j == k ? std::sqrt(left) : left / matrix[k][k];
        }
}

Square inverse(const Square& lower, std::size_t size) {
    Square inverse{};
    for (std::size_t j = 0; j < size; ++j) {
        inverse[j][j] = 1 / lower[j][j];
        for (std::size_t k = 0; k < j; ++k)
            for (std::size_t i = k; i < j; ++i)
                inverse[j][k] -= lower[j][i] * inverse[i][k] / lower[j][j];
    }
    return inverse;
}

} // namespace

FlowWeights weights_at(const Circuit& circuit, std::span<const CircuitSample> samples, const FlowConstants& flow,
                       std::span<const double> compliance_in3_per_psi, double mean_square) {
    Square matrix = covariance_at(circuit, samples, flow, compliance_in3_per_psi);
    factorise(matrix, circuit.size());
    FlowWeights weights{inverse(matrix, circuit.size())};
    for (auto& row : weights.rows)
        for (double& entry : row)
            entry *= std::sqrt(mean_square / static_cast<double>(circuit.size()));
    return weights;
}

} // namespace placedpar::identification
