#include "identification/identification.hpp"

#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "identification/compliance_fit.hpp"
#include "identification/flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace placedpar {

using namespace hydraulics;

namespace {

/// Is there a link whose pressure moves too slowly, if its compliance is what it was last found to be?
bool is_unexcited(std::span<const CircuitSample> window, std::span<const double> compliance_in3_per_psi,
                  const ExcitationGate& gate) {
    for (std::size_t j = 0; j < compliance_in3_per_psi.size(); ++j) {
        double slope = excitation_psi_per_s(window, j);
        if (slope < gate.slope_psi_per_s && slope * compliance_in3_per_psi[j] < gate.flow_in3_per_s)
            return true;
    }
    return false;
}

/// The value below which a share of the values lies, between neighbours as far as that.
double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    double place = share * static_cast<double>(values.size() - 1);
    auto below = static_cast<std::size_t>(place);
    double above = values[std::min(below + 1, values.size() - 1)];
    return values[below] + (place - static_cast<double>(below)) * (above - values[below]);
}

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

/// The length of the longest window without a gap that the samples could fill.
std::size_t longest_stretch(std::span<const CircuitSample> samples) {
    std::size_t longest = 0, length = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        length = i > 0 && samples[i].stretch == samples[i - 1].stretch ? length + 1 : 1;
        longest = std::max(longest, length);
    }
    return longest;
}

void require_samples(std::span<const CircuitSample> samples, const IdentificationWay& way) {
    std::size_t needed = samples_for_first_generation(way), found = longest_stretch(samples);
    if (found < needed)
        throw UnfitRecord(fmt::format(
            "{} usable samples{}, expected at least {}: the transient after the valve opens, with the pressure rising "
            "faster than {} psi/s, is too short or not in the record",
            found, found < samples.size() ? " without a gap" : "", needed, way.usable.first_slope_psi_per_s));
}

std::vector<double> last_answers(std::span<const SearchRun> runs, std::size_t junction) {
    std::vector<double> answers;
    for (const SearchRun& run : runs)
        answers.push_back(run.estimates.back().compliance_in3_per_psi[junction]);
    return answers;
}

/// Everything about one junction's compliance but its flags.
LinkIdentified summary(hydraulics::Link link, const std::vector<double>& answers) {
    LinkIdentified identified{};
    identified.link = link;
    identified.compliance_in3_per_psi = quantile(answers, 0.5);
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
        link.codes_from_optimum = quantile(distances, 0.5);
    }
}

} // namespace

std::size_t samples_for_first_generation(const IdentificationWay& way) {
    return std::min(way.search.window.first, way.search.window.length);
}

SearchRun search_transient(const CircuitProblem& circuit_problem, std::span<const CircuitSample> samples,
                           const IdentificationWay& way, RandomStream random) {
    require_samples(samples, way);
    auto search_problem = make_search_problem(circuit_problem, way.coding);
    const SearchProblem& problem = *search_problem;
    Search search(problem.bits(), way.search, std::move(random));
    SlidingWindow window(way.search.window);
    SearchRun run;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i > 0 && samples[i].stretch != samples[i - 1].stretch)
            window.clear();
        window.push(samples[i].values());
        if (!window.ready())
            continue;
        auto in_window = samples.subspan(i + 1 - window.samples().size(), window.samples().size());
        bool frozen = way.gate && !run.estimates.empty() &&
                      is_unexcited(in_window, run.estimates.back().compliance_in3_per_psi, *way.gate);
        for (std::size_t trial = 0; !frozen && trial < way.search.window.trials; ++trial)
            search.next_generation(evaluate(problem, search.population(), window.samples(), way.search.window.bias));
        double mean_square =
            way.search.window.bias - search.best().fitness / static_cast<double>(window.samples().size());
        run.estimates.push_back({samples[i].index, samples[i].time_s, frozen,
                                 frozen ? run.estimates.back().error_in3_per_s : std::sqrt(std::max(mean_square, 0.0)),
                                 problem.decode(search.best().genome)});
    }
    run.generations = search.generation();
    return run;
}

IdentificationWay thesis_way() { return {}; }

IdentificationWay rising_way() {
    IdentificationWay way = thesis_way();
    way.usable.rising = true;
    return way;
}

IdentificationWay service_way() {
    IdentificationWay way;
    way.coding = Coding::gray;
    way.search.elite = 1;
    way.usable.skipped = 2;
    way.gate.emplace();
    way.searches = 21;
    return way;
}

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

} // namespace placedpar
