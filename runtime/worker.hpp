#pragma once

#include "runtime/stack_arena.hpp"
#include "runtime/switched_stack.hpp"

#include <boost/fiber/context.hpp>

#include <cstddef>

namespace placedpar {

class Kernel;
class Process;

/// A fiber that runs the bodies of processes, one after the other. It never ends: Boost's way to end one takes 5 Kbyte
/// of its stack, another page of memory for each, and with a worker without a process there is nothing to unwind.
class Worker {
public:
    /// The memory must outlast it.
    Worker(Kernel&, const Stack& memory);
    /// Leaves the fiber where it is. REQUIRES: it runs no process.
    ~Worker() { context_->worker_unlink(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    void resume() { context_->resume(); }
    /// Worth its time where there are so many workers that their stacks are in no cache: notes how far the stack of the
    /// process that leaves is in use, and begins to fetch what the next one looks at first. REQUIRES: the caller runs
    /// on the stack of the one that leaves, which may be null or have ended.
    [[gnu::noinline]] static void fetch_stack(const Process* leaves, const Process& next);

    Process* process = nullptr; ///< whose body it runs, or will run next
    const Stack memory;
    SwitchedStack stack;

private:
    [[noreturn]] void work(Kernel&);

    boost::fibers::context* context_;
    const std::byte* stack_ends_ = nullptr; ///< where it was left; null where nobody has noted that
};

} // namespace placedpar
