#pragma once

#include "hydraulics/circuit/circuit.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// The fifteen population sets of Figure 3.13: one for every non-empty set of links, in the figure's order.
const std::array<hydraulics::LinkSet, 15>& all_population_sets();

/// "P1a" ... "P4". REQUIRES: not empty.
std::string_view name_of_set(hydraulics::LinkSet);
std::optional<hydraulics::LinkSet> set_named(std::string_view);

/// Links in the order in which a set's binary string codes them: the order of Figure 3.13 in every circuit.
std::vector<hydraulics::Link> links_of(hydraulics::LinkSet);
/// Where the link stands in links_of(set). REQUIRES: set.contains(link).
std::size_t position_in(hydraulics::LinkSet set, hydraulics::Link link);

/// The sets to be searched while these links are active: from each coupled group of the configuration its active links.
/// Ordered by name.
std::vector<hydraulics::LinkSet> sets_in_use(hydraulics::Configuration, hydraulics::LinkSet active);

} // namespace placedpar::identification
