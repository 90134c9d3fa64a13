#pragma once

#include "explore/generate/job.hpp"

#include <string>

namespace placedpar::generate {

/// Returns the processes that run a graph of tasks, from a file of comma-separated values. The columns are `task`,
/// `cycles`, `successors` and, optionally, `processor`. Successors "b:100 c:4" mean that the task sends 100 bytes to b
/// and 4 bytes to c. `processor` is the number of a processor; without this column, tasks are assigned to the
/// processors in turn. Throws RefusedInput.
Job tasks_of_file(const std::string& path, std::size_t processors, const Topology&);

} // namespace placedpar::generate
