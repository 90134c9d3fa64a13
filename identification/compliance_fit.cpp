#include "identification/compliance_fit.hpp"

#include "gaprocs/population_fitness.hpp"
#include "identification/flow_weights.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

constexpr auto most_junctions = static_cast<int>(all_links.size());
// These types have a fixed greatest size, so they need no heap memory.
using PerLinkVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_junctions, 1>;
using PerLinkMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_junctions, most_junctions>;
using Slopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, most_junctions>;

/// Computes the missing flow (the error of the flow balance) for each sample and junction, as a function of the
/// compliances.
class Residuals {
public:
    /// `weights` scale the missing flows; null: the flows are not scaled.
    Residuals(const Circuit& circuit, std::span<const CircuitSample> samples, const FlowConstants& flow,
              const FlowWeights* weights)
        : circuit_(circuit), flow_(flow), weights_(weights) {
        terms_.reserve(samples.size());
        for (const CircuitSample& sample : samples)
            terms_.push_back(terms_of(sample.links, flow));
    }

    Eigen::VectorXd operator()(const PerLinkVector& compliance) const {
        const auto junctions = static_cast<Eigen::Index>(circuit_.size());
        Eigen::VectorXd missing(static_cast<Eigen::Index>(terms_.size()) * junctions);
        Eigen::Index row = 0;
        for (const CircuitTerms& terms : terms_) {
            auto flows =
                missing_flows_in3_per_s<double>(circuit_, std::span<const double>(compliance.data(), circuit_.size()),
                                                terms, flow_, InletFlow::as_signed);
            if (weights_)
                flows = weights_->scaled<double>(flows, circuit_.size());
            for (std::size_t j = 0; j < circuit_.size(); ++j)
                missing[row++] = flows[j];
        }
        return missing;
    }
    Slopes slopes(const PerLinkVector& compliance) const {
        constexpr double step = 1e-6; // in^3/psi; central differences at compliances near 0.01 are accurate to 1e-8
        Slopes slopes(static_cast<Eigen::Index>(terms_.size() * circuit_.size()), compliance.size());
        for (Eigen::Index c = 0; c < compliance.size(); ++c) {
            PerLinkVector shift = PerLinkVector::Unit(compliance.size(), c) * step;
            slopes.col(c) = ((*this)(compliance + shift) - (*this)(compliance - shift)) / (2 * step);
        }
        return slopes;
    }

private:
    const Circuit& circuit_;
    const FlowConstants& flow_;
    const FlowWeights* weights_;
    std::vector<CircuitTerms> terms_;
};

ComplianceFit fit_at(const PerLinkVector& compliance, const Eigen::VectorXd& missing,
                     const Eigen::FullPivLU<PerLinkMatrix>& normal) {
    auto freedom = static_cast<double>(std::max<Eigen::Index>(missing.size() - compliance.size(), 1));
    double variance = missing.squaredNorm() / freedom;
    ComplianceFit fit{
        {compliance.begin(), compliance.end()},
        std::vector<double>(static_cast<std::size_t>(compliance.size()), std::numeric_limits<double>::infinity()),
        std::sqrt(missing.squaredNorm() / static_cast<double>(missing.size()))};
    if (normal.isInvertible()) {
        PerLinkMatrix covariance = variance * normal.inverse();
        for (Eigen::Index c = 0; c < compliance.size(); ++c)
            if (covariance(c, c) >= 0 && std::isfinite(covariance(c, c))) // the condition is false for NaN
                fit.standard_error[static_cast<std::size_t>(c)] = std::sqrt(covariance(c, c));
    }
    return fit;
}

/// Returns the fitness of every string. The string, read as a number, is its index in the result. The leftmost bits of
/// a string are the first junction's code. The fitness is not rounded, as a search would round it.
std::vector<double> fitness_of_all(const Circuit& circuit, std::span<const CircuitSample> window,
                                   const FlowConstants& flow, InletFlow form, std::size_t bits, double largest,
                                   double bias) {
    std::uint64_t codes = std::uint64_t{1} << bits;
    auto compliances_of = [&](std::uint64_t string) {
        std::vector<double> compliances(circuit.size());
        for (std::size_t j = circuit.size(); j-- > 0; string /= codes)
            compliances[j] = largest * static_cast<double>(string % codes) / static_cast<double>(codes);
        return compliances;
    };
    auto term = [&]<class T>(std::span<const T> compliances, const CircuitSample& sample) -> T {
        T error = circuit_error_in3_per_s<T>(circuit, compliances, sample.links, flow, form);
        return bias - error * error;
    };
    std::vector<double> fitness(std::size_t{1} << (circuit.size() * bits));
    sum_in_lanes(compliances_of, window, term, fitness);
    return fitness;
}

/// Fits compliances by the Gauss-Newton method.
std::optional<ComplianceFit> fit(const Circuit& circuit, std::span<const CircuitSample> samples,
                                 const FlowConstants& flow, std::span<const double> start, const FlowWeights* weights) {
    constexpr int most_steps = 50;
    constexpr double settled = 1e-9; // in^3/psi
    if (samples.empty())
        return std::nullopt;
    const Residuals residuals(circuit, samples, flow, weights);
    PerLinkVector compliance = Eigen::Map<const Eigen::VectorXd>(start.data(), std::ssize(start));
    Eigen::VectorXd missing = residuals(compliance);
    for (int i = 0; i < most_steps; ++i) {
        const Slopes slopes = residuals.slopes(compliance);
        const Eigen::FullPivLU<PerLinkMatrix> normal(slopes.transpose() * slopes);
        PerLinkVector step = normal.solve(slopes.transpose() * missing);
        if (!step.allFinite())
            return std::nullopt;
        if (step.cwiseAbs().maxCoeff() < settled)
            return fit_at(compliance, missing, normal);
        // Far from the solution a full step may be too long, because the square root of the orifice equation is not
        // linear. Therefore the step is halved until the missing flows are not greater than before.
        Eigen::VectorXd then = residuals(compliance - step);
        while (then.squaredNorm() > missing.squaredNorm() && step.cwiseAbs().maxCoeff() >= settled) {
            step /= 2;
            then = residuals(compliance - step);
        }
        compliance -= step;
        missing = then;
    }
    return std::nullopt;
}

} // namespace

std::optional<ComplianceFit> fit_compliances(const Circuit& circuit, std::span<const CircuitSample> samples,
                                             const FlowConstants& flow, std::span<const double> start) {
    return fit(circuit, samples, flow, start, nullptr);
}

std::optional<ComplianceFit> fit_weighed_compliances(const Circuit& circuit, std::span<const CircuitSample> samples,
                                                     const FlowConstants& flow, std::span<const double> start) {
    constexpr int turns = 10; // the weights settle within five turns
    auto found = fit(circuit, samples, flow, start, nullptr);
    for (int i = 0; i < turns && found; ++i) {
        const FlowWeights weights =
            weights_at(circuit, samples, flow, found->compliance_in3_per_psi, static_cast<double>(circuit.size()));
        found = fit(circuit, samples, flow, std::vector(found->compliance_in3_per_psi), &weights);
    }
    return found;
}

ExhaustiveOptimum exhaustive_optimum(const Circuit& circuit, std::span<const CircuitSample> window,
                                     const FlowConstants& flow, InletFlow form, std::size_t bits,
                                     double largest_in3_per_psi, double bias) {
    assert(circuit.size() * bits <= exhaustive_bits);
    std::vector<double> fitness = fitness_of_all(circuit, window, flow, form, bits, largest_in3_per_psi, bias);
    std::uint64_t best = 0;
    double greatest = -std::numeric_limits<double>::infinity();
    for (std::uint64_t string = 0; string < fitness.size(); ++string)
        if (fitness[string] > greatest) { // the condition is false for NaN
            greatest = fitness[string];
            best = string;
        }
    ExhaustiveOptimum optimum{{}, greatest};
    for (std::size_t j = 0; j < circuit.size(); ++j)
        optimum.codes.push_back((best >> (bits * (circuit.size() - 1 - j))) % (std::uint64_t{1} << bits));
    return optimum;
}

} // namespace placedpar::identification
