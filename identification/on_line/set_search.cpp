#include "identification/on_line/set_search.hpp"

#include "identification/compliance_fit.hpp"
#include "identification/flow_weights.hpp"
#include "identification/on_line/population_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

SetSearch::SetSearch(LinkSet set, const WholeWay& way, const FlowConstants& flow, RandomStream random,
                     std::size_t most_samples)
    : set_(set), way_(way), flow_(flow), search_(set.size() * way.way.bits, way.way.search, std::move(random)),
      most_samples_(most_samples) {}

SetSearchState SetSearch::state() const {
    SearchState search = search_.state();
    SetSearchState state{std::move(search.population), search.generation, search.drawn, rounds_, fresh_, {}};
    for (const auto& [configuration, part] : parts_)
        state.configurations.push_back(part.of);
    return state;
}

void SetSearch::go_on_from(SetSearchState state) {
    search_.go_on_from({state.generations, 0, state.drawn, std::move(state.population), std::nullopt});
    rounds_ = state.rounds;
    fresh_ = state.fresh;
    for (ConfigurationSamples& each : state.configurations)
        part_of(each.configuration).of = std::move(each);
}

std::size_t SetSearch::samples() const {
    std::size_t count = 0;
    for (const auto& [configuration, part] : parts_)
        count += part.of.samples.size();
    return count;
}

std::size_t SetSearch::newest_index() const {
    std::size_t newest = 0;
    for (const auto& [configuration, part] : parts_)
        if (!part.of.samples.empty())
            newest = std::max(newest, part.of.samples.back().index);
    return newest;
}

SetSearch::Part& SetSearch::part_of(Configuration configuration) {
    return parts_
        .try_emplace(configuration,
                     Part{SetProblem(configuration, set_, flow_, way_.way.bits), {configuration, {}, {}}})
        .first->second;
}

void SetSearch::drop_oldest() {
    std::vector<CircuitSample>* oldest = nullptr;
    for (auto& [configuration, part] : parts_)
        if (auto& all = part.of.samples; !all.empty() && (!oldest || all.front().index < oldest->front().index))
            oldest = &all;
    oldest->erase(oldest->begin());
}

void SetSearch::add(Configuration configuration, CircuitSample sample) {
    if (samples() == most_samples_)
        drop_oldest();
    part_of(configuration).of.samples.push_back(std::move(sample));
    ++fresh_;
}

std::vector<double> SetSearch::found_in(const Part& part) const {
    std::vector<double> found;
    for (std::size_t position : part.problem.positions())
        found.push_back(part.problem.compliance_in3_per_psi(best(), position));
    return found;
}

bool SetSearch::round() {
    const bool makes = samples() >= fewest_samples && fresh_ > 0;
    if (makes)
        evolve();
    return makes;
}

void SetSearch::evolve() {
    const double bias = way_.way.search.window.bias;
    std::map<Configuration, std::vector<CircuitTerms>> terms;
    for (const auto& [configuration, part] : parts_)
        for (const CircuitSample& sample : part.of.samples)
            terms[configuration].push_back(terms_of(sample.links, flow_));
    for (std::size_t trial = 0; trial < way_.way.search.window.trials; ++trial) {
        std::vector<double> fitness(search_.population().size());
        for (const auto& [configuration, part] : parts_) {
            const FlowWeights weights{part.of.weights.value_or(PerJunction<PerJunction<double>>())};
            const auto added = part.problem.fitness(search_.population(), terms[configuration], bias,
                                                    part.of.weights ? &weights : nullptr);
            std::ranges::transform(fitness, added, fitness.begin(), std::plus());
        }
        search_.next_generation(fitness);
    }
    for (auto& [configuration, part] : parts_)
        if (!part.of.samples.empty())
            part.of.weights =
                weights_at(part.problem.circuit(), part.of.samples, flow_, found_in(part), share_of_bias * bias).rows;
    fresh_ = 0;
    ++rounds_;
}

std::vector<LeastSquares> SetSearch::least_squares() const {
    std::vector<std::vector<LeastSquares>> of_links(set_.size());
    for (const auto& [configuration, part] : parts_) {
        if (part.of.samples.size() < fewest_samples)
            continue;
        const auto fit = fit_weighed_compliances(part.problem.circuit(), part.of.samples, flow_, found_in(part));
        for (std::size_t j = 0; fit && j < set_.size(); ++j)
            of_links[part.problem.positions()[j]].push_back({fit->compliance_in3_per_psi[j], fit->standard_error[j]});
    }
    std::vector<LeastSquares> all;
    for (const auto& results : of_links)
        all.push_back(combined(results));
    return all;
}

std::optional<SetAnswer> SetSearch::answer() {
    if (samples() < fewest_samples)
        return std::nullopt;
    while (rounds_ < way_.rounds || fresh_ > 0)
        evolve();
    return answer_so_far();
}

SetAnswer SetSearch::answer_so_far() const {
    SetAnswer answer{set_, "", samples(), search_.generation(), {}};
    const Part& any = parts_.begin()->second;
    const std::vector<LeastSquares> least = least_squares();
    for (const auto& [configuration, part] : parts_)
        answer.configurations += name_of(configuration);
    for (Link link : links_of(set_)) {
        const std::size_t position = position_in(set_, link);
        LinkIdentified found{link, any.problem.compliance_in3_per_psi(best(), position)};
        found.of_all_samples = least[position];
        found.standard_error = least[position].standard_error;
        if (at_lower_bound(found.compliance_in3_per_psi, any.problem.step_in3_per_psi()))
            found.flags.push_back(lower_bound_flag());
        else if (at_upper_bound(found.compliance_in3_per_psi, any.problem.step_in3_per_psi()))
            found.flags.push_back(upper_bound_flag());
        else if (auto flag = unconfirmed_flag(found.compliance_in3_per_psi, least[position], "the same samples"))
            found.flags.push_back(*flag);
        flag_limit(found);
        answer.links.push_back(std::move(found));
    }
    return answer;
}

LeastSquares combined(const std::vector<LeastSquares>& results) {
    double weights = 0, sum = 0, exact = 0;
    for (const auto& [compliance, error] : results) {
        if (!std::isfinite(error) || !(compliance > 0))
            continue;
        const double weight = 1 / (error * error + std::pow(model_share * compliance, 2));
        weights += weight;
        sum += weight * compliance;
        exact += 1 / (error * error);
    }
    return weights > 0 ? LeastSquares{sum / weights, std::hypot(std::sqrt(1 / exact), model_share * sum / weights)}
                       : LeastSquares{};
}

} // namespace placedpar::identification
