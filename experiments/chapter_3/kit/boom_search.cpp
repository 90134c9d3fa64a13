#include "experiments/chapter_3/kit/boom_search.hpp"

#include "gaprocs/search.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "identification/compliance_fit.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr std::array fit_start_in3_per_psi{0.0086};
constexpr std::size_t fewest_to_fit = 5;

std::optional<double> fit(std::span<const CircuitSample> samples, const FlowConstants& flow) {
    if (samples.size() < fewest_to_fit)
        return std::nullopt;
    auto found = fit_compliances(boom_circuit(), samples, flow, fit_start_in3_per_psi);
    return found ? std::optional(found->compliance_in3_per_psi[0]) : std::nullopt;
}

/// Returns the mean absolute error over all individuals and all samples of the window.
double mean_error(const SearchProblem& problem, std::span<const Genome> population, std::span<const Sample> window) {
    double sum = 0;
    for (const Genome& genome : population)
        for (const Sample& sample : window)
            sum += problem.error(genome, sample);
    return sum / static_cast<double>(population.size() * window.size());
}

} // namespace

std::vector<CircuitSample> usable_of(const BoomData& data, const BoomModel& model, const UsableSamples& rule) {
    return usable_samples(samples_of(data, model), boom_circuit(), data.flow, rule);
}

std::optional<double> least_squares_compliance(const BoomData& data, const BoomModel& model,
                                               const UsableSamples& rule) {
    return fit(usable_of(data, model, rule), data.flow);
}

BoomIdentified identify_boom(const BoomData& data, const BoomModel& model, const IdentificationWay& way,
                             std::uint64_t seed) {
    auto samples = usable_of(data, model, way.usable);
    CircuitProblem problem(boom_circuit(), data.flow, way.bits);
    Identified found = identify(problem, data.flow, samples, way, seed);
    const LinkIdentified& boom = found.links.front();
    bool at_bound = boom.flagged(FlagKind::lower_bound);
    auto least_squares = fit(samples, data.flow);
    return {std::move(samples), found, boom.compliance_in3_per_psi, least_squares, at_bound};
}

std::vector<Generation> watch_search(const BoomData& data, std::span<const CircuitSample> samples,
                                     const IdentificationWay& way, std::uint64_t seed) {
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), data.flow, way.bits), way.coding);
    Search search(problem->bits(), way.search, RandomStream(seed, "master"));
    SlidingWindow window(way.search.window);
    std::vector<Generation> generations;
    for (const CircuitSample& sample : samples) {
        window.push(sample.values());
        for (std::size_t trial = 0; window.ready() && trial < way.search.window.trials; ++trial) {
            double mean = mean_error(*problem, search.population(), window.samples());
            search.next_generation(evaluate(*problem, search.population(), window.samples(), way.search.window.bias));
            double square =
                way.search.window.bias - search.best().fitness / static_cast<double>(window.samples().size());
            generations.push_back(
                {sample.time_s, problem->decode(search.best().genome)[0], std::sqrt(std::max(square, 0.0)), mean});
        }
    }
    return generations;
}

} // namespace placedpar
