#pragma once

#include <map>
#include <string>

namespace placedpar {

class Catalogue; // netlist/kinds/catalogue.hpp
struct Network;  // netlist/network/network.hpp

/// Prices of the parts of a machine, by the type of a node ("T800", "C004"); "link" is the price of a wire.
using Prices = std::map<std::string, double>;

/// Returns the price of all parts that the netlist declares. A part without a price costs nothing.
double price_of(const Network&, const Prices&);
/// Throws UserError if a price is given for an unknown part.
void require_parts(const Prices&, const Catalogue&);

} // namespace placedpar
