#include "identification/transient_search.hpp"

#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// Returns whether the pressure of at least one link changes too slowly for the search (excitation_gate.hpp), if the
/// links have these compliances.
bool is_unexcited(std::span<const CircuitSample> window, std::span<const double> compliance_in3_per_psi,
                  const ExcitationGate& gate) {
    for (std::size_t j = 0; j < compliance_in3_per_psi.size(); ++j)
        if (!gate.opens(excitation_psi_per_s(window, j), compliance_in3_per_psi[j]))
            return true;
    return false;
}

/// Returns the length of the longest run of samples without a gap.
std::size_t longest_stretch(std::span<const CircuitSample> samples) {
    std::size_t longest = 0, length = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        length = i > 0 && samples[i].stretch == samples[i - 1].stretch ? length + 1 : 1;
        longest = std::max(longest, length);
    }
    return longest;
}

/// Returns the previous estimate, but with the time of this sample.
TransientEstimate frozen_estimate(const CircuitSample& sample, TransientEstimate estimate) {
    estimate.index = sample.index;
    estimate.time_s = sample.time_s;
    estimate.frozen = true;
    return estimate;
}

/// Makes the generations that belong to one sample, and returns the new estimate.
TransientEstimate next_estimate(const CircuitSample& sample, const SearchProblem& problem, Search& search,
                                const SlidingWindow& window, const WindowSettings& settings) {
    for (std::size_t trial = 0; trial < settings.trials; ++trial)
        search.next_generation(evaluate(problem, search.population(), window.samples(), settings.bias));
    double mean_square = settings.bias - search.best().fitness / static_cast<double>(window.samples().size());
    return {sample.index, sample.time_s, false, std::sqrt(std::max(mean_square, 0.0)),
            problem.decode(search.best().genome)};
}

} // namespace

void require_samples(std::span<const CircuitSample> samples, const IdentificationWay& way) {
    std::size_t needed = samples_for_first_generation(way), found = longest_stretch(samples);
    if (found < needed)
        throw UnfitRecord(fmt::format(
            "{} usable samples{}, expected at least {}: the transient after the valve opens, in which the "
            "pressure rises faster than {} psi/s, is too short or missing",
            found, found < samples.size() ? " without a gap" : "", needed, way.usable.first_slope_psi_per_s));
}

SearchRun search_transient(const CircuitProblem& circuit_problem, std::span<const CircuitSample> samples,
                           const IdentificationWay& way, RandomStream random) {
    require_samples(samples, way);
    auto problem = make_search_problem(circuit_problem, way.coding);
    Search search(problem->bits(), way.search, std::move(random));
    SlidingWindow window(way.search.window);
    SearchRun run;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i > 0 && samples[i].stretch != samples[i - 1].stretch)
            window.clear();
        window.push(samples[i].values());
        if (!window.ready())
            continue;
        auto in_window = samples.subspan(i + 1 - window.samples().size(), window.samples().size());
        if (way.gate && !run.estimates.empty() &&
            is_unexcited(in_window, run.estimates.back().compliance_in3_per_psi, *way.gate))
            run.estimates.push_back(frozen_estimate(samples[i], run.estimates.back()));
        else
            run.estimates.push_back(next_estimate(samples[i], *problem, search, window, way.search.window));
    }
    run.generations = search.generation();
    return run;
}

} // namespace placedpar::identification
