#pragma once

#include "netlist/kinds/catalogue.hpp"

#include <string>

namespace placedpar {

/// Returns a catalogue of process kinds for the tests of the language; their processes never run. The kinds and their
/// ports are:
///   "ga.master": `in` (optional) of numbers, `out` of genomes, `back` of errors;
///   "ga.slave": `in` of genomes, `out` of errors;
///   "pump": `out` of numbers;
///   "sink": `in` of numbers;
///   "csp.switch_logic" and "csp.switching_producer", for switches, with their usual ports.
const Catalogue& small_catalogue();

/// Returns the folder of the tests' netlists, without a slash at the end.
std::string netlist_folder();

} // namespace placedpar
