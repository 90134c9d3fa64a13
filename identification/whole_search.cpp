#include "identification/whole_search.hpp"

#include "gaprocs/search.hpp"
#include "gaprocs/traditional.hpp"
#include "identification/compliance_fit.hpp"
#include "identification/flags.hpp"
#include "identification/flow_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// The number of samples in the thesis's window. These samples at the beginning show whether the pressure changes fast
/// enough.
constexpr std::size_t transient_samples = 10;

std::vector<Sample> values_of(std::span<const CircuitSample> samples) {
    std::vector<Sample> values;
    for (const CircuitSample& sample : samples)
        values.push_back(sample.values());
    return values;
}

/// Returns the rms of the error of equation 3.11.
double rms_error(const CircuitProblem& problem, std::span<const Sample> samples, std::span<const double> compliance) {
    double squares = 0;
    for (const Sample& sample : samples) {
        double error = problem.error_of<double>(compliance, std::span<const double>(sample));
        squares += error * error;
    }
    return std::sqrt(squares / static_cast<double>(samples.size()));
}

/// Makes the generations of all rounds, and returns the estimate after each round.
SearchRun search_whole(const ComplianceSearch& prepared, std::span<const CircuitSample> used, const WholeWay& whole,
                       RandomStream random) {
    const SearchSettings& settings = whole.way.search;
    const std::vector<Sample> values = values_of(used);
    std::shared_ptr<const SearchProblem> problem = make_search_problem(prepared.problem, whole.way.coding);
    Search search(problem->bits(), settings, std::move(random));
    SearchRun run;
    for (std::size_t round = 0; round < whole.rounds; ++round) {
        for (std::size_t i = 0; i < settings.window.trials; ++i)
            search.next_generation(evaluate(*problem, search.population(), values, settings.window.bias));
        std::vector<double> best = problem->decode(search.best().genome);
        const CircuitSample& last = used.back();
        run.estimates.push_back({last.index, last.time_s, false, rms_error(prepared.problem, values, best), best});
        problem = make_search_problem(WeighedCircuit(prepared.problem, prepared.flow,
                                                     weights_at(prepared.problem.circuit(), used, prepared.flow, best,
                                                                share_of_bias * settings.window.bias)),
                                      whole.way.coding);
    }
    run.generations = search.generation();
    return run;
}

/// Stores with each answer the result of weighted least squares over all samples, for comparison.
void compare_with_weighed_fit(Identified& result, std::span<const CircuitSample> samples, const FlowConstants& flow) {
    std::vector<double> found;
    for (const LinkIdentified& link : result.links)
        found.push_back(link.compliance_in3_per_psi);
    auto fit = fit_weighed_compliances(result.circuit, samples, flow, found);
    for (std::size_t j = 0; j < result.links.size(); ++j) {
        LinkIdentified& link = result.links[j];
        link.of_all_samples =
            fit ? LeastSquares{fit->compliance_in3_per_psi[j], fit->standard_error[j]} : LeastSquares{};
        link.standard_error = link.of_all_samples->standard_error;
    }
}

} // namespace

WholeWay whole_way(std::size_t links, Side side) {
    constexpr std::array<std::size_t, 4> populations{120, 200, 300, 600}, generations{20, 30, 50, 80};
    WholeWay whole;
    whole.way.bits = 12;
    whole.way.coding = Coding::gray;
    whole.way.search.elite = 2;
    whole.way.search.population = populations[links - 1];
    whole.way.search.window.trials = generations[links - 1];
    whole.way.search.window.length = exact_fitness_terms;
    if (side == Side::inlet)
        whole.way.usable.count = exact_fitness_terms;
    return whole;
}

void flag_limit(LinkIdentified& link) {
    constexpr double share = 0.1, errors = 3;
    const double least = link.of_all_samples->compliance_in3_per_psi;
    const double off = std::abs(link.compliance_in3_per_psi - least) + errors * link.standard_error;
    if (std::isfinite(link.standard_error) && off > share * least && !link.flagged(FlagKind::unconfirmed))
        link.flags.push_back(
            {FlagKind::uncertain,
             fmt::format("uncertain: with this noise, the standard error is at least {:.1f} %, so the answer "
                         "may be wrong by more than {:.0f} % (three standard errors)",
                         100 * link.standard_error / link.compliance_in3_per_psi, 100 * share)});
}

Identified identify_whole(const ComplianceSearch& prepared, const WholeWay& whole, std::uint64_t seed) {
    std::span<const CircuitSample> used(prepared.samples);
    if (std::size_t needed = samples_for_first_generation(whole.way); used.size() < needed)
        throw UnfitRecord(fmt::format("{} usable samples, expected at least {}: the record lacks a movement in "
                                      "which every valve opens and every pressure rises faster than {} psi/s",
                                      used.size(), needed, whole.way.usable.first_slope_psi_per_s));
    used = used.first(std::min(used.size(), exact_fitness_terms));
    SearchRun run = search_whole(prepared, used, whole, RandomStream(seed, "master"));
    Identified result{prepared.problem.circuit(), {}, std::move(run.estimates), run.generations};
    for (std::size_t j = 0; j < result.circuit.size(); ++j)
        result.links.push_back({result.circuit[j].link, result.estimates.back().compliance_in3_per_psi[j]});
    compare_with_weighed_fit(result, used, prepared.flow);
    // Only the transient at the beginning of a movement determines the compliances.
    const auto transient = used.first(std::min(used.size(), UsableSamples{}.count));
    add_flags(result, prepared.problem, prepared.flow, used, transient.first(std::min(used.size(), transient_samples)),
              transient, whole.way);
    for (LinkIdentified& link : result.links)
        flag_limit(link);
    return result;
}

SearchCost cost_of(const WholeWay& whole, const CircuitProblem& problem, std::uint64_t generations,
                   std::size_t samples) {
    constexpr double hertz = 20e6, cycles_per_error = 1440, cycles_per_individual = 1750;
    constexpr double processors = 16, masters = 4;
    const double individuals = static_cast<double>(whole.way.search.population) * static_cast<double>(generations);
    const double errors = individuals * static_cast<double>(samples);
    const double evaluation_s = errors * cycles_per_error * static_cast<double>(problem.circuit().size()) / hertz;
    const double breeding_s =
        individuals * cycles_per_individual * static_cast<double>(problem.bits()) / CircuitProblem::usual_bits / hertz;
    return {individuals, errors, evaluation_s + breeding_s, evaluation_s / processors + breeding_s / masters};
}

} // namespace placedpar::identification
