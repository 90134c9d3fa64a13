#pragma once

#include "gaprocs/processes/farm.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/representation/coding.hpp"
#include "gaprocs/settings.hpp"

#include <string>

namespace placedpar {

class ProcessEnvironment;

// The parameters that the process kinds describe, in the form that their bodies use.

Split split_named(const std::string&); ///< as the parameter "split" names it
Workload read_workload(const ProcessEnvironment&);
Workload read_slave_workload(const ProcessEnvironment&); ///< only what a slave uses
Coding read_coding(const ProcessEnvironment&);
SearchSettings read_search_settings(const ProcessEnvironment&);
Farm::Settings read_farm_settings(const ProcessEnvironment&);

} // namespace placedpar
