#pragma once

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/problem_registry.hpp"
#include "gaprocs/search_observer.hpp"
#include "netlist/kinds/process_kind.hpp"

namespace placedpar {

class Catalogue;

/// Adds the kinds of processes below to the catalogue, so that netlists can use them. Processes find their problems in
/// `problems` by name. Searches report to the observer, unless it is null. The traditional algorithm, masters and
/// islands use the checkpoints, unless these are null. REQUIRES: `problems`, the observer and the checkpoints outlive
/// every run.
void add_genetic_algorithm_kinds(Catalogue&, const ProblemRegistry& problems, SearchObserver* observer = nullptr,
                                 Checkpoints* checkpoints = nullptr);

// The file of each kind holds the program of its processes and describes their purpose, ports, parameters and
// measurements.

ProcessKind host_kind(const ProblemRegistry& problems);     ///< ga.host, in host.cpp
ProcessKind slave_kind(const ProblemRegistry& problems);    ///< ga.slave, in slave.cpp
ProcessKind sensors_kind(const ProblemRegistry& problems);  ///< ga.sensors, in sensors_and_alarm.cpp
ProcessKind alarm_kind(const ProblemRegistry& problems);    ///< ga.alarm, in sensors_and_alarm.cpp
ProcessKind pipeline_kind(const ProblemRegistry& problems); ///< ga.pipeline, in pipeline.cpp
ProcessKind traditional_kind(const ProblemRegistry& problems, SearchObserver*,
                             Checkpoints*); ///< ga.traditional, in traditional.cpp
ProcessKind master_kind(const ProblemRegistry& problems, SearchObserver*, Checkpoints*); ///< ga.master, in master.cpp
ProcessKind island_kind(const ProblemRegistry& problems, SearchObserver*, Checkpoints*); ///< ga.island, in island.cpp
ProcessKind analyst_kind(const ProblemRegistry& problems, SearchObserver*);              ///< ga.analyst, in analyst.cpp
ProcessKind coarse_kind(const ProblemRegistry& problems, SearchObserver*);               ///< ga.coarse, in pair.cpp
ProcessKind fine_kind(const ProblemRegistry& problems, SearchObserver*);                 ///< ga.fine, in pair.cpp

} // namespace placedpar
