#pragma once

#include "runtime/stack_arena.hpp"
#include "runtime/switched_stack.hpp"

#include <boost/fiber/context.hpp>

#include <cstddef>
#include <memory>

namespace placedpar {

class Kernel;
class Process;
struct EndWorker;

/// A fiber that runs the bodies of processes, one after another. It never ends, because the end of a Boost fiber uses 5
/// Kbyte of its stack, which is another page of memory for each fiber. A worker without a process has nothing to
/// unwind.
class Worker {
public:
    /// Makes a worker at the upper end of the stack, where a switch to the worker reads anyway. REQUIRES: the stack
    /// outlives the worker.
    static std::unique_ptr<Worker, EndWorker> make(Kernel&, const Stack&);
    /// Destroys the worker without resuming its fiber. REQUIRES: the worker runs no process.
    ~Worker() { context_->worker_unlink(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    void resume() { context_->resume(); }
    /// Records how much of the leaving process's stack is in use, and prefetches the data that the next process needs
    /// first. This saves time if there are too many workers for their stacks to stay in a cache. REQUIRES: the caller
    /// runs on the stack of the leaving process. `leaves` is null if no process leaves; the process may have ended.
    [[gnu::noinline]] static void fetch_stack(Process* leaves, const Process& next);

    Process* process = nullptr; ///< process whose body the worker runs, or will run next
    const Stack memory;
    SwitchedStack stack;

private:
    Worker(Kernel&, const Stack& memory);
    [[noreturn]] void work(Kernel&);

    boost::fibers::context* context_;
};

} // namespace placedpar
