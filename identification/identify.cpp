#include "identification/identification.hpp"

#include "identification/compliance_fit.hpp"
#include "identification/flags.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// Returns the last estimate that is not frozen. An estimate is frozen while the pressure changes too slowly.
const TransientEstimate& last_live(std::span<const TransientEstimate> estimates) {
    return *std::ranges::find(estimates.rbegin(), estimates.rend(), false, &TransientEstimate::frozen);
}

std::span<const CircuitSample> last_window(std::span<const CircuitSample> samples, const TransientEstimate& last,
                                           std::size_t length) {
    auto end = std::ranges::find(samples, last.index, &CircuitSample::index) + 1;
    auto size = static_cast<std::size_t>(end - samples.begin()), first = size - std::min(size, length);
    while (samples[first].stretch != samples[size - 1].stretch)
        ++first;
    return samples.subspan(first, size - first);
}

/// Returns the least-squares fit to these samples. The fit starts at the search's answer.
std::optional<ComplianceFit> fit_beside(const Identified& result, std::span<const CircuitSample> samples,
                                        const FlowConstants& flow) {
    std::vector<double> found;
    for (const LinkIdentified& link : result.links)
        found.push_back(link.compliance_in3_per_psi);
    return fit_compliances(result.circuit, samples, flow, found);
}

void compare_with_least_squares(Identified& result, std::span<const CircuitSample> window, const FlowConstants& flow) {
    auto fit = fit_beside(result, window, flow);
    for (std::size_t j = 0; j < result.links.size(); ++j)
        result.links[j].standard_error = fit ? fit->standard_error[j] : std::numeric_limits<double>::infinity();
}

/// Stores with each answer the result of least squares over all samples, for comparison. A search for several
/// compliances can settle on a wrong string, and a short window of samples does not show that the string is wrong.
void compare_with_all_samples(Identified& result, std::span<const CircuitSample> samples, const FlowConstants& flow) {
    auto fit = fit_beside(result, samples, flow);
    for (std::size_t j = 0; j < result.links.size(); ++j)
        result.links[j].of_all_samples =
            fit ? LeastSquares{fit->compliance_in3_per_psi[j], fit->standard_error[j]} : LeastSquares{};
}

void compare_with_optimum(Identified& result, const CircuitProblem& problem, const FlowConstants& flow,
                          std::span<const CircuitSample> window, const IdentificationWay& way) {
    auto optimum = exhaustive_optimum(problem.circuit(), window, flow, problem.inlet_flow(), problem.field().bits,
                                      CircuitProblem::largest_in3_per_psi, way.search.window.bias);
    for (std::size_t j = 0; j < result.links.size(); ++j) {
        LinkIdentified& link = result.links[j];
        link.optimum = problem.field().value(optimum.codes[j]);
        link.codes_from_optimum =
            std::round(std::abs(link.compliance_in3_per_psi - *link.optimum) / problem.field().resolution());
    }
}

} // namespace

Identified identify(const CircuitProblem& problem, const FlowConstants& flow, std::span<const CircuitSample> samples,
                    const IdentificationWay& way, std::uint64_t seed) {
    SearchRun run = search_transient(problem, samples, way, RandomStream(seed, "master"));
    Identified result{problem.circuit(), {}, std::move(run.estimates), run.generations};
    auto window = last_window(samples, last_live(result.estimates), way.search.window.length);
    for (std::size_t j = 0; j < problem.circuit().size(); ++j)
        result.links.push_back({problem.circuit()[j].link, result.estimates.back().compliance_in3_per_psi[j]});

    compare_with_least_squares(result, window, flow);
    if (result.links.size() > 1)
        compare_with_all_samples(result, samples, flow);
    if (problem.bits() <= exhaustive_bits)
        compare_with_optimum(result, problem, flow, window, way);
    add_flags(result, problem, flow, samples, window, samples, way);
    return result;
}

} // namespace placedpar::identification
