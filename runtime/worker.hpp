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

/// A fiber that runs the bodies of processes, one after another. The fiber never ends by itself, because the end of a
/// Boost fiber would touch another page of its stack. A worker without a process has nothing to clean up, so it can be
/// destroyed.
class Worker {
public:
    /// Makes a worker at the upper end of the stack. A switch to the worker reads this memory anyway. REQUIRES: the
    /// stack outlives the worker.
    static std::unique_ptr<Worker, EndWorker> make(Kernel&, const Stack&);
    /// Destroys the worker without resuming its fiber. REQUIRES: the worker runs no process.
    ~Worker() { context_->worker_unlink(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    void resume() { context_->resume(); }
    /// Records how much of the leaving process's stack is in use, and prefetches the part of the next process's stack
    /// that it needs first. This saves time if the stacks of all workers do not fit into the cache. REQUIRES: the
    /// caller runs on the stack of the leaving process. `leaves` is null if no process leaves; the process may have
    /// ended.
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
