#pragma once

#include "gaprocs/policies/noun.hpp"

#include <vector>

namespace placedpar {

/// What there is to decide: first what one population does, then islands, a pair, a farm.
std::vector<Noun> policy_nouns();

} // namespace placedpar
