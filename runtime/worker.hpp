#pragma once

#include "runtime/stack_arena.hpp"
#include "runtime/switched_stack.hpp"

#include <boost/fiber/context.hpp>

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

    Process* process = nullptr; ///< whose body it runs, or will run next
    const Stack memory;
    SwitchedStack stack;

private:
    [[noreturn]] void work(Kernel&);

    boost::fibers::context* context_;
};

} // namespace placedpar
