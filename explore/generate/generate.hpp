#pragma once

#include "explore/generate/distances.hpp"
#include "explore/generate/wish.hpp"
#include "netlist/kinds/catalogue.hpp"

#include <string>

namespace placedpar::generate {

/// A netlist that has been read and checked.
struct Generated {
    std::string text;
    Distances distances;
};

/// Throws UserError where there is no such topology, job or size, or no transputer has the links.
Generated generate(const Wish&, const Catalogue&);

} // namespace placedpar::generate
