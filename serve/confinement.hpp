#pragma once

#include <cstddef>
#include <cstdint>

namespace placedpar::serve {

/// The size of the largest answer (JSON) of a run. If an answer is longer, the user gets a message instead.
inline constexpr std::size_t largest_answer_bytes = 24u << 20;

/// The limits of a run that a user of the web page starts. The values are this project's choice.
struct RunLimits {
    std::uint64_t seconds = 10; ///< after this time the run is interrupted, and a little later its process is killed
    std::uint64_t megabytes = 1024; ///< limit of the address space, of which the program itself needs about 100 Mbyte
};

/// Confines this process for ever, because it is going to run a program of an unknown user. From now on the process can
/// only compute, and read and write files that are already open. It cannot open, create or look for a file, connect,
/// start a program, send a signal to another process, or exceed the limits. Forbidden system calls fail with an error.
/// Throws UserError if this computer cannot confine processes.
///
/// A list of forbidden calls instead of a list of allowed calls would let new system calls of Linux pass. Landlock
/// would let a process find out which files exist.
void confine(const RunLimits&);

} // namespace placedpar::serve
