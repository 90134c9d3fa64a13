#pragma once

#include <cstddef>
#include <cstdint>

namespace placedpar::serve {

/// Size of the largest answer of a run, as JSON.
inline constexpr std::size_t largest_answer_bytes = 24u << 20;

/// Holds the limits of a run. We chose the values.
struct RunLimits {
    std::uint64_t seconds = 10;     ///< time limit; after this time the run is interrupted, and a little later killed
    std::uint64_t megabytes = 1024; ///< limit of the address space, of which the program itself needs about 100 Mbyte
};

/// Confines this process for ever: from now on it can compute, and read and write files that are already open. It
/// cannot open, create or look for a file, connect, start a program, send a signal to another process, or exceed the
/// limits. Every other system call fails with an error. Throws UserError if this computer cannot confine processes.
///
/// We rejected a list of forbidden calls, since it would allow new system calls of Linux. We rejected Landlock, since
/// it lets a process find out which files exist.
void confine(const RunLimits&);

} // namespace placedpar::serve
