#pragma once

#include "runtime/time.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace placedpar {

class Kernel;
struct Deadlock;

/// Returns the pause before a kernel that must poll for messages looks again. `waited`: for how long the kernel has had
/// nothing to do. The pause is an eighth of this time. So a pause makes a wait only a little longer, and an idle kernel
/// uses little of a core's time.
constexpr Time pause_after(Time waited) {
    constexpr Time shortest = std::chrono::microseconds(20), longest = std::chrono::milliseconds(4);
    return std::clamp(waited / 8, shortest, longest);
}

/// What a kernel of a native run needs from outside: the wall clock, and the messages of other kernels. In a native run
/// the processes run in real time, on several threads or in several programs (MPI ranks), each with its own kernel. A
/// kernel without surroundings keeps virtual time, and is alone.
class Surroundings {
public:
    virtual ~Surroundings() = default;

    /// Returns the time since the beginning of the run.
    virtual Time now() const = 0;
    /// Handles the messages of other kernels that have come since the last call. Does not wait.
    virtual void take_arrivals() noexcept = 0;

    enum class Rest {
        over,   ///< a message or an interruption has come, or `due` has been reached
        quiet,  ///< no kernel has anything left to do, so the work is over; some processes wait for its end, and
                ///< continue
        forever ///< no kernel has anything left to do, and no process waits for the end of the work: the run is over
    };
    /// Waits until a message comes, `due` is reached, or the kernel is interrupted. Called when no process is ready.
    /// `awaits_end`: processes of the kernel wait for the end of the work.
    virtual Rest rest(Time due, bool awaits_end) = 0;

    /// Waits until all kernels of the run have stopped. Each kernel calls this function once, while its processes are
    /// still in their waits. `failed`: a process of this kernel has thrown, so the other kernels must stop, too.
    virtual void wait_for_stop(bool failed) = 0;
    /// Returns all kernels of the run, by their numbers.
    virtual std::vector<const Kernel*> kernels() const = 0;
    /// Waits until all kernels have called this function, after their reports. From then on, no kernel needs the
    /// processes of another kernel.
    virtual void wait_for_reports() = 0;
};

} // namespace placedpar
