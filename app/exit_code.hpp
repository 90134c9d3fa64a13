#pragma once

#include "runtime/kernel.hpp"

namespace placedpar {

/// What the program's exit code says; documented in README.md.
enum class ExitCode {
    success = 0,
    bad_input = 1,        ///< wrong use, or input that is refused
    deadlock = 2,         ///< processes were left that nothing would ever wake
    missed_tolerance = 3, ///< a cell of a comparison is further from the thesis than it may be; with --strict, an
                          ///< answer is flagged
    defect = 70,          ///< of PlacedPar itself; the number that sysexits.h has for it
    interrupted = 130     ///< by a signal, as shells count it; what was measured so far is printed
};

/// Of a run that ended so. A run that reached its time limit is a success: the user set the limit.
ExitCode exit_code_of(Ending);

} // namespace placedpar
