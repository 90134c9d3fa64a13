#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <string>

namespace placedpar {

/// Prints the network as a model for Spin: a proctype for each process, a rendezvous channel for each channel. The
/// model has neither time nor placement: an event that Spin proves impossible cannot happen on any machine, and an
/// event that Spin finds possible may happen on some machine. Spin reports a process that never reaches its end
/// as an invalid end state; PlacedPar reports it as waiting. Throws UserError if the kind of a process has no Promela
/// statements, or if there are more processes than Spin allows.
std::string print_promela(const Network& network, const Catalogue& catalogue);

} // namespace placedpar
