#pragma once

#include "gaprocs/policies/coding.hpp"
#include "gaprocs/processes/farm.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/settings.hpp"

#include <string>

namespace placedpar {

class ProcessEnvironment;

// The parameters that the process kinds describe, in the form that their bodies use.

Split split_named(const std::string&); ///< as the parameter "split" names it
/// An objective problem has no measurements to send.
Workload read_workload(const ProcessEnvironment&, const SearchProblem&);
Workload read_slave_workload(const ProcessEnvironment&); ///< only what a slave uses
Coding read_coding(const ProcessEnvironment&);
/// What the netlist does not give is as usual_settings() where that depends on the problem. Throws as settings_for().
SearchSettings read_search_settings(const ProcessEnvironment&, const SearchProblem&);
Farm::Settings read_farm_settings(const ProcessEnvironment&);

} // namespace placedpar
