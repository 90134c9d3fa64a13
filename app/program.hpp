#pragma once

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "gaprocs/problem_family.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/process_kind.hpp"

#include <vector>

namespace placedpar {

/// A function that adds a user's own policy to the policies for one step of a genetic search, such as
/// Reproduction::add<Truncation> (gaprocs/policies/policy.hpp).
using AddPolicy = void (*)();

/// Runs a user's own program: the main() of that program calls this function and returns the result, the exit code. The
/// program has the commands of placedpar, except those for the thesis's experiments and for the monitor. It adds its
/// own process kinds, search problems, policies and devices to PlacedPar's. Messages and help use the name of the
/// program's file. A name that is already taken is reported as a user's error.
int run_program(int argc, char** argv, std::vector<ProcessKind> own_kinds, std::vector<ProblemFamily> own_problems = {},
                std::vector<AddPolicy> own_policies = {}, std::vector<DeviceKind> own_devices = {});

} // namespace placedpar
