#pragma once

#include "hydraulics/circuit/circuit.hpp"

#include <vector>

namespace placedpar {

/// Returns the non-empty subsets of `links`.
inline std::vector<hydraulics::LinkSet> non_empty_subsets(hydraulics::LinkSet links) {
    std::vector<hydraulics::LinkSet> subsets{{}};
    for (hydraulics::Link link : hydraulics::all_links)
        if (links.contains(link))
            for (std::size_t i = 0, size = subsets.size(); i < size; ++i)
                subsets.push_back(subsets[i] | hydraulics::LinkSet{link});
    subsets.erase(subsets.begin());
    return subsets;
}

/// Calls check(configuration, active links, circuit) for every circuit of every configuration: the non-empty
/// subsets of its coupled groups, 52 in all.
template <typename Check>
void for_each_circuit(Check check) {
    for (hydraulics::Configuration configuration : hydraulics::all_configurations)
        for (hydraulics::LinkSet group : coupled_groups(configuration))
            for (hydraulics::LinkSet active : non_empty_subsets(group))
                check(configuration, active, circuit_of(configuration, active));
}

} // namespace placedpar
