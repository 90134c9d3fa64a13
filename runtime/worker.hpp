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

/// A fiber that runs the bodies of processes, one after the other. It never ends: Boost's way to end one takes 5 Kbyte
/// of its stack, another page of memory for each, and with a worker without a process there is nothing to unwind.
class Worker {
public:
    /// At the beginning of that stack, which must outlast it: a switch to the worker reads that page of memory
    /// anyway.
    static std::unique_ptr<Worker, EndWorker> make(Kernel&, const Stack&);
    /// Leaves the fiber where it is. REQUIRES: it runs no process.
    ~Worker() { context_->worker_unlink(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    void resume() { context_->resume(); }
    /// Worth its time where there are so many workers that their stacks are in no cache: notes how far the stack of the
    /// process that leaves is in use, and begins to fetch what the next one looks at first. REQUIRES: the caller runs
    /// on the stack of the one that leaves, which may be null or have ended.
    [[gnu::noinline]] static void fetch_stack(Process* leaves, const Process& next);

    Process* process = nullptr; ///< whose body it runs, or will run next
    const Stack memory;
    SwitchedStack stack;

private:
    Worker(Kernel&, const Stack& memory);
    [[noreturn]] void work(Kernel&);

    boost::fibers::context* context_;
};

} // namespace placedpar
