#include "monitor/memory/settled_estimates.hpp"

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

SettledEstimates::SettledEstimates(const Diagnosis& diagnosis) {
    for (const SetEstimates& set : diagnosis.estimates())
        for (std::size_t i = 0; i < set.links.size(); ++i)
            before_[{set.set, i}] = {set.links[i].state().settled, set.links[i].state().settled_time_s};
}

std::vector<KeptEstimate> SettledEstimates::ended(const Diagnosis& diagnosis, double at) const {
    std::vector<KeptEstimate> ended;
    for (const SetEstimates& set : diagnosis.estimates())
        for (std::size_t i = 0; i < set.links.size(); ++i) {
            const LinkEstimate::State& e = set.links[i].state();
            if (!has_ended({set.set, i}, e))
                continue;
            ended.push_back({diagnosis.name(), at, e.settled_time_s, std::string(name_of_set(set.set)),
                             std::string(symbol_of(links_of(set.set)[i])), e.settled_in3_per_psi.back(),
                             e.settled_error_in3_per_psi});
        }
    return ended;
}

/// A transient has ended if the estimate was settled and no longer is, or if a round of a search gave a new value.
bool SettledEstimates::has_ended(const SettledLink& link, const LinkEstimate::State& now) const {
    if (now.settled || now.settled_in3_per_psi.empty())
        return false;
    auto found = before_.find(link);
    return found == before_.end() || found->second.settled || found->second.time_s != now.settled_time_s;
}

} // namespace placedpar::monitor
