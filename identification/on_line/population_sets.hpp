#pragma once

#include "hydraulics/circuit/circuit.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// The fifteen population sets of Figure 3.13: one for every non-empty set of links, in the figure's order.
const std::array<hydraulics::LinkSet, 15>& all_population_sets();

/// "P1a" ... "P4". REQUIRES: not empty.
std::string_view name_of_set(hydraulics::LinkSet);
std::optional<hydraulics::LinkSet> set_named(std::string_view);

/// Links in the order in which a set's binary string codes them: that of Figure 3.13, whatever the circuit.
std::vector<hydraulics::Link> links_of(hydraulics::LinkSet);

/// The sets that are searched while these links are active: the active part of each coupled group of the
/// configuration. Ordered by name.
std::vector<hydraulics::LinkSet> sets_in_use(hydraulics::Configuration, hydraulics::LinkSet active);

} // namespace placedpar::monitor
