#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <string>

namespace placedpar {

/// Prints the network in Promela, the language of the model checker Spin, so that a user can prove that it has no
/// deadlock. The model has a proctype for each process and a rendezvous channel for each channel. It has neither time
/// nor placement: what Spin proves impossible cannot happen on any machine, and what Spin finds possible may happen on
/// some machine. A process that never reaches its end is an invalid end state in Spin; PlacedPar reports this process
/// as waiting. Throws UserError if the kind of a process has no Promela statements, or if there are more processes than
/// Spin allows.
std::string print_promela(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
