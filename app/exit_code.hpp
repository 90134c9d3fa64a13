#pragma once

#include "netlist/run_outcome.hpp"

namespace placedpar {

/// The exit codes of the program; docs/guides/when-something-is-wrong.md explains them.
enum class ExitCode {
    success = 0,
    bad_input = 1,        ///< wrong use, or refused input; or a program of the run has failed
    deadlock = 2,         ///< at the end of the run, some processes waited and nothing could wake them
    missed_tolerance = 3, ///< a compared value is outside its tolerance; or, with --strict, an answer has a warning
    defect = 70,          ///< a defect of this program; EX_SOFTWARE of sysexits.h
    interrupted = 130     ///< a signal interrupted the run; the results so far are printed; as in shells
};

/// Returns the exit code of a run with this outcome. A run that reached its time limit is a success, because the
/// user set the limit.
ExitCode exit_code_of(RunOutcome);

} // namespace placedpar
