#pragma once

#include "runtime/time.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace placedpar {

class Kernel;
struct Deadlock;

/// Returns for how long a kernel that no message can wake pauses before it looks for messages again. `waited`: for how
/// long the kernel has had nothing to do. Because the pause is an eighth of this time, it makes a wait only a little
/// longer, and an idle kernel uses hardly any of a core's time.
constexpr Time pause_after(Time waited) {
    constexpr Time shortest = std::chrono::microseconds(20), longest = std::chrono::milliseconds(4);
    return std::clamp(waited / 8, shortest, longest);
}

/// The parts of a native run outside of a kernel: the wall clock, and the other kernels of the run. A kernel without
/// surroundings keeps virtual time, and is alone.
class Surroundings {
public:
    virtual ~Surroundings() = default;

    /// Returns the time since the beginning of the run.
    virtual Time now() const = 0;
    /// Handles the messages of other kernels that have come since the last call. Does not wait or throw.
    virtual void take_arrivals() noexcept = 0;

    enum class Rest {
        over,   ///< a message or an interruption has come, or `due` has been reached
        quiet,  ///< no kernel has anything to do any more, but some processes wait for the end of the work: the work is
                ///< over
        forever ///< no kernel has anything to do any more, and no process waits for the end of the work: the run is
                ///< over
    };
    /// Waits until a message comes, `due` is reached, or the kernel is interrupted. Called when no process is ready.
    /// `awaits_end`: processes of the kernel wait for the end of the work.
    virtual Rest rest(Time due, bool awaits_end) = 0;

    /// Returns when all kernels of the run have stopped. Each kernel calls this function once, while its processes are
    /// still in their waits. `failed`: a process of this kernel has thrown, so the other kernels must stop, too.
    virtual void wait_for_stop(bool failed) = 0;
    /// Returns all kernels of the run, by their numbers.
    virtual std::vector<const Kernel*> kernels() const = 0;
    /// Returns when all kernels have called this function. From then on, no kernel needs the processes of another
    /// kernel.
    virtual void wait_for_reports() = 0;
};

} // namespace placedpar
