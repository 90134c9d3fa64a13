#pragma once

#include "runtime/stack_arena.hpp"
#include "runtime/switched_stack.hpp"

#include <boost/fiber/context.hpp>

namespace placedpar {

class Kernel;
class Process;

/// A fiber that runs the bodies of processes, one after the other.
class Worker {
public:
    /// The memory must outlast the run.
    Worker(Kernel&, const Stack& memory);
    void resume() { context_->resume(); }

    Process* process = nullptr; ///< whose body it runs, or will run next
    bool dismissed = false;     ///< it ends when it is resumed next
    const Stack memory;
    SwitchedStack stack;

private:
    void work(Kernel&);

    boost::fibers::context* context_;
};

} // namespace placedpar
