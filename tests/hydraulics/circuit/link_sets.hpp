#pragma once

#include "hydraulics/circuit/circuit.hpp"

#include <vector>

namespace placedpar {

/// The non-empty subsets of `links`.
inline std::vector<LinkSet> non_empty_subsets(LinkSet links) {
    std::vector<LinkSet> subsets{{}};
    for (MachineLink link : all_links)
        if (links.contains(link))
            for (std::size_t i = 0, size = subsets.size(); i < size; ++i)
                subsets.push_back(subsets[i] | LinkSet{link});
    subsets.erase(subsets.begin());
    return subsets;
}

/// Calls check(configuration, active links, circuit) for every circuit of every configuration: the non-empty
/// subsets of its coupled groups, 52 in all.
template <typename Check>
void for_each_circuit(Check check) {
    for (Configuration configuration : all_configurations)
        for (LinkSet group : coupled_groups(configuration))
            for (LinkSet active : non_empty_subsets(group))
                check(configuration, active, circuit_of(configuration, active));
}

} // namespace placedpar
