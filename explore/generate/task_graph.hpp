#pragma once

#include "explore/generate/job.hpp"

#include <string>

namespace placedpar::generate {

/// Returns a job that runs a graph of tasks, from a file of comma-separated values with the columns `task`, `cycles`,
/// `successors` ("b:100 c:4" sends 100 bytes to b and 4 to c) and, optionally, `processor` (the number of a processor;
/// without this column, tasks are assigned to the processors in turn). Throws RefusedInput.
Job tasks_of_file(const std::string& path, std::size_t processors, const Topology&);

} // namespace placedpar::generate
