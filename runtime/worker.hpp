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

/// A fiber that runs the bodies of processes, one after another. It never ends, since ending a fiber in Boost's way
/// uses 5 Kbyte of its stack, which is another page of memory for each. A worker without a process has nothing to
/// unwind.
class Worker {
public:
    /// Makes a worker at the beginning of the stack, which must outlast it: a switch to the worker reads that page
    /// anyway.
    static std::unique_ptr<Worker, EndWorker> make(Kernel&, const Stack&);
    /// Destroys the worker where its fiber stands. REQUIRES: it runs no process.
    ~Worker() { context_->worker_unlink(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    void resume() { context_->resume(); }
    /// Notes how much of the leaving process's stack is in use, and prefetches what the next process needs first. It is
    /// worth its time if there are so many workers that their stacks are in no cache. REQUIRES: the caller runs on the
    /// stack of the leaving process, which may be null or have ended.
    [[gnu::noinline]] static void fetch_stack(Process* leaves, const Process& next);

    Process* process = nullptr; ///< the process whose body it runs, or will run next
    const Stack memory;
    SwitchedStack stack;

private:
    Worker(Kernel&, const Stack& memory);
    [[noreturn]] void work(Kernel&);

    boost::fibers::context* context_;
};

} // namespace placedpar
