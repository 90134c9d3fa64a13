#include "monitor/memory/settled_estimates.hpp"

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

SettledEstimates::SettledEstimates(const Diagnosis& diagnosis) {
    for (const auto& [set, population] : diagnosis.sets())
        for (std::size_t i = 0; i < population.state().estimates.size(); ++i)
            if (population.state().estimates[i].state().settled)
                settled_.push_back({set, i});
}

std::vector<KeptEstimate> SettledEstimates::ended(const Diagnosis& diagnosis, double at) const {
    std::vector<KeptEstimate> ended;
    for (const SettledLink& place : settled_) {
        const LinkEstimate::State& e = diagnosis.sets().at(place.set).state().estimates[place.link].state();
        if (!e.settled)
            ended.push_back({diagnosis.name(), at, e.settled_time_s, std::string(name_of_set(place.set)),
                             std::string(symbol_of(links_of(place.set)[place.link])), e.settled_in3_per_psi.back(),
                             e.settled_error_in3_per_psi});
    }
    return ended;
}

} // namespace placedpar::monitor
