#include "monitor/memory/settled_estimates.hpp"

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace {

/// Calls use(recognised, set, index of the link, estimate) for each estimate in reported and recognised configurations.
template <typename Use>
void for_each_estimate(const Diagnosis& diagnosis, Use use) {
    for (const auto& [set, population] : diagnosis.sets())
        for (std::size_t i = 0; i < set.size(); ++i)
            use(false, set, i, population.state().estimates[i].state());
    if (diagnosis.recognises())
        for (const SetEstimates& set : diagnosis.estimates())
            for (std::size_t i = 0; i < set.links.size(); ++i)
                use(true, set.set, i, set.links[i].state());
}

} // namespace

SettledEstimates::SettledEstimates(const Diagnosis& diagnosis) {
    for_each_estimate(diagnosis, [&](bool recognised, LinkSet set, std::size_t i, const LinkEstimate::State& e) {
        before_[{recognised, set, i}] = {e.settled, e.settled_time_s};
    });
}

std::vector<KeptEstimate> SettledEstimates::ended(const Diagnosis& diagnosis, double at) const {
    std::vector<KeptEstimate> ended;
    for_each_estimate(diagnosis, [&](bool recognised, LinkSet set, std::size_t i, const LinkEstimate::State& e) {
        if (has_ended({recognised, set, i}, e))
            ended.push_back({diagnosis.name(), at, e.settled_time_s, std::string(name_of_set(set)),
                             std::string(symbol_of(links_of(set)[i])), e.settled_in3_per_psi.back(),
                             e.settled_error_in3_per_psi});
    });
    return ended;
}

/// Returns whether a transient has ended: the estimate was settled and is not settled any more, or a round of a search
/// gave a new value.
bool SettledEstimates::has_ended(const SettledLink& link, const LinkEstimate::State& now) const {
    if (now.settled || now.settled_in3_per_psi.empty())
        return false;
    auto found = before_.find(link);
    return found == before_.end() || found->second.settled || found->second.time_s != now.settled_time_s;
}

} // namespace placedpar::monitor
