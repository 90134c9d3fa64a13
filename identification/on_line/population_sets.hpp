#pragma once

#include "hydraulics/circuit/circuit.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// A population set is a set of links whose compliances one population of a genetic algorithm searches together,
/// because the links share oil. This function returns the fifteen population sets of Figure 3.13 of the thesis: all
/// non-empty sets of the four links, in the figure's order.
const std::array<hydraulics::LinkSet, 15>& all_population_sets();

/// Returns the name in Figure 3.13, "P1a" to "P4". REQUIRES: the set is not empty.
std::string_view name_of_set(hydraulics::LinkSet);
std::optional<hydraulics::LinkSet> set_named(std::string_view);

/// Returns the links in the order in which a set's string codes their compliances. The order is that of Figure 3.13,
/// also if the hydraulic circuit has another order.
std::vector<hydraulics::Link> links_of(hydraulics::LinkSet);
/// Returns the index of the link in links_of(set). REQUIRES: set.contains(link).
std::size_t position_in(hydraulics::LinkSet set, hydraulics::Link link);

/// Returns the population sets that are searched while these links are active, ordered by name. Each set has the active
/// links of one coupled group, that is, of links that share oil in this configuration (hydraulics::coupled_groups()).
std::vector<hydraulics::LinkSet> sets_in_use(hydraulics::Configuration, hydraulics::LinkSet active);

} // namespace placedpar::identification
