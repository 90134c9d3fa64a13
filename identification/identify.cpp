#include "identification/identification.hpp"

#include "identification/compliance_fit.hpp"
#include "identification/flags.hpp"
#include "identification/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// The samples of the last window that a generation saw.
std::span<const CircuitSample> last_window(std::span<const CircuitSample> samples,
                                           std::span<const TransientEstimate> estimates, std::size_t length) {
    auto last = std::ranges::find(estimates.rbegin(), estimates.rend(), false, &TransientEstimate::frozen);
    auto end = std::ranges::find(samples, last->index, &CircuitSample::index) + 1;
    auto size = static_cast<std::size_t>(end - samples.begin()), first = size - std::min(size, length);
    while (samples[first].stretch != samples[size - 1].stretch)
        ++first;
    return samples.subspan(first, size - first);
}

std::vector<double> last_answers(std::span<const SearchRun> runs, std::size_t junction) {
    std::vector<double> answers;
    for (const SearchRun& run : runs)
        answers.push_back(run.estimates.back().compliance_in3_per_psi[junction]);
    return answers;
}

/// Everything about one junction's compliance but its flags.
LinkIdentified summary(Link link, const std::vector<double>& answers) {
    LinkIdentified identified{};
    identified.link = link;
    identified.compliance_in3_per_psi = median(answers);
    identified.lowest = quantile(answers, 0.05);
    identified.highest = quantile(answers, 0.95);
    return identified;
}

void compare_with_least_squares(Identified& result, std::span<const CircuitSample> window, const FlowConstants& flow) {
    std::vector<double> answer;
    for (const LinkIdentified& link : result.links)
        answer.push_back(link.compliance_in3_per_psi);
    auto fit = fit_compliances(result.circuit, window, flow, answer);
    for (std::size_t j = 0; j < result.links.size(); ++j)
        result.links[j].standard_error = fit ? fit->standard_error[j] : std::numeric_limits<double>::infinity();
}

void compare_with_optimum(Identified& result, std::span<const SearchRun> runs, const CircuitProblem& problem,
                          const FlowConstants& flow, std::span<const CircuitSample> window,
                          const IdentificationWay& way) {
    auto optimum = exhaustive_optimum(problem.circuit(), window, flow, problem.inlet_flow(), problem.field().bits,
                                      CircuitProblem::largest_in3_per_psi, way.search.window.bias);
    for (std::size_t j = 0; j < result.links.size(); ++j) {
        LinkIdentified& link = result.links[j];
        link.optimum = problem.field().value(optimum.codes[j]);
        std::vector<double> distances;
        for (double each : last_answers(runs, j))
            distances.push_back(std::round(std::abs(each - *link.optimum) / problem.field().resolution()));
        link.codes_from_optimum = median(distances);
    }
}

} // namespace

Identified identify(const CircuitProblem& problem, const FlowConstants& flow, std::span<const CircuitSample> samples,
                    const IdentificationWay& way, std::uint64_t seed) {
    std::vector<SearchRun> runs;
    for (std::size_t i = 0; i < way.searches; ++i)
        runs.push_back(search_transient(problem, samples, way,
                                        RandomStream(seed, i == 0 ? "master" : fmt::format("search {}", i))));
    Identified result{problem.circuit(), {}, runs.front().estimates, 0};
    for (const SearchRun& run : runs)
        result.generations += run.generations;
    auto window = last_window(samples, result.estimates, way.search.window.length);
    for (std::size_t j = 0; j < problem.circuit().size(); ++j)
        result.links.push_back(summary(problem.circuit()[j].link, last_answers(runs, j)));

    compare_with_least_squares(result, window, flow);
    if (problem.bits() <= exhaustive_bits)
        compare_with_optimum(result, runs, problem, flow, window, way);
    add_flags(result, problem, flow, samples, window, way);
    return result;
}

} // namespace placedpar::identification
