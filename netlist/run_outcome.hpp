#pragma once

namespace placedpar {

/// How a run of a network ended, if the programs that the transputers executed are taken into account. The order is
/// from the best to the worst outcome, by which `explain` sorts the runs that it tries.
enum class RunOutcome {
    completed,
    time_limit,
    failed, ///< a program exited with failure, or an error has stopped one of its processes
    halted, ///< an error of a program has halted a processor
    deadlock,
    interrupted
};

/// Returns a text such as "completed", "deadlock", "program failed" or "halted by an error".
const char* name_of(RunOutcome);

} // namespace placedpar
