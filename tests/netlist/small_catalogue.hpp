#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <string>

namespace placedpar {

/// Process kinds for the tests of the language: they never run.
///
/// "ga.master": in (optional) of numbers, out of genomes, back of errors; "ga.slave": in of genomes, out of
/// errors; "pump": out of numbers; "sink": in of numbers. Those of switches, "csp.switch_logic" and
/// "csp.switching_producer".
const Catalogue& small_catalogue();

/// Returns the folder of the tests' netlists, without a slash at the end.
std::string netlist_folder();

} // namespace placedpar
